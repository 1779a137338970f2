#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LaserTracking.Patterns
{
    internal static unsafe partial class SaddleKernel
    {
        private static int SmoothAlongVector(byte* padded, int width, ushort* target)
        {
            int x = 0;
            // The weights' sum is 256: sixteen bits hold it all.
            for (; x + 16 <= width; x += 16)
            {
                byte* p = padded + x;
                Vector256<ushort> sum = Widen(p) + Widen(p + 8) + Vector256.Create((ushort)8)
                    + Vector256.ShiftLeft(Widen(p + 1) + Widen(p + 7), 3)
                    + (Widen(p + 2) + Widen(p + 6)) * (ushort)28
                    + (Widen(p + 3) + Widen(p + 5)) * (ushort)56
                    + Widen(p + 4) * (ushort)70;
                Vector256.ShiftRightLogical(sum, 4).Store(target + x);
            }

            return x;
        }

        private static int SmoothAcrossVector(ushort** rows, int width, ushort* target)
        {
            int x = 0;
            for (; x + 16 <= width; x += 16)
            {
                Vector256<ushort> a = Vector256.Load(rows[0] + x) + Vector256.Load(rows[8] + x);
                Vector256<ushort> b = Vector256.Load(rows[1] + x) + Vector256.Load(rows[7] + x);
                Vector256<ushort> c = Vector256.Load(rows[2] + x) + Vector256.Load(rows[6] + x);
                Vector256<ushort> d = Vector256.Load(rows[3] + x) + Vector256.Load(rows[5] + x);
                Vector256<ushort> e = Vector256.Load(rows[4] + x);
                Vector256<uint> lower = Weigh(
                    Vector256.WidenLower(a), Vector256.WidenLower(b), Vector256.WidenLower(c), Vector256.WidenLower(d), Vector256.WidenLower(e));
                Vector256<uint> upper = Weigh(
                    Vector256.WidenUpper(a), Vector256.WidenUpper(b), Vector256.WidenUpper(c), Vector256.WidenUpper(d), Vector256.WidenUpper(e));
                Vector256.Narrow(lower, upper).Store(target + x);
            }

            return x;
        }

        private static int RespondVector(ushort* above, ushort* row, ushort* below, int width, int* target)
        {
            int x = 1;
            for (; x + 16 < width; x += 16)
            {
                Vector256<short> twice = Vector256.ShiftLeft(Load(row + x), 1);
                Vector256<short> xx = Load(row + x - 1) + Load(row + x + 1) - twice;
                Vector256<short> yy = Load(above + x) + Load(below + x) - twice;
                Vector256<short> xy = Vector256.ShiftRightArithmetic(
                    Load(above + x - 1) + Load(below + x + 1) - Load(above + x + 1) - Load(below + x - 1), 2);
                Determinant(Vector256.WidenLower(xx), Vector256.WidenLower(yy), Vector256.WidenLower(xy)).Store(target + x);
                Determinant(Vector256.WidenUpper(xx), Vector256.WidenUpper(yy), Vector256.WidenUpper(xy)).Store(target + x + 8);
            }

            return x;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<ushort> Widen(byte* p)
        {
            (Vector128<ushort> lower, Vector128<ushort> upper) = Vector128.Widen(Vector128.Load(p));
            return Vector256.Create(lower, upper);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<uint> Weigh(Vector256<uint> a, Vector256<uint> b, Vector256<uint> c, Vector256<uint> d, Vector256<uint> e) =>
            Vector256.ShiftRightLogical(a + Vector256.ShiftLeft(b, 3) + c * 28u + d * 56u + e * 70u + Vector256.Create(128u), 8);

        /// <summary>Smoothed levels stay below 4096, so their sums and differences fit into sixteen bits with a sign.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<short> Load(ushort* p) => Vector256.Load((short*)p);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<int> Determinant(Vector256<int> xx, Vector256<int> yy, Vector256<int> xy) => xy * xy - xx * yy;
    }
}
#endif
