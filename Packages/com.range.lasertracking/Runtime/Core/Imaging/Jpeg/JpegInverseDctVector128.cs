#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.Arm;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Imaging
{
    /// <summary>The arithmetic of <see cref="JpegInverseDct"/> on four columns, then four rows, at once: for ARM and older x86.</summary>
    internal static unsafe class JpegInverseDctVector128
    {
        public static bool IsSupported => Sse41.IsSupported || AdvSimd.Arm64.IsSupported;

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void Transform(short* coefficients, byte* samples)
        {
            // Columns to rows: each half of the columns, transposed, is the left or right half of what the second pass works on.
            int* workspace = stackalloc int[64];
            const int columnShift = JpegInverseDct.ConstantBits - JpegInverseDct.PassBits;
            for (int x = 0; x < 8; x += 4)
            {
                Vector128<int> r0 = Widen(coefficients + x);
                Vector128<int> r1 = Widen(coefficients + x + 8);
                Vector128<int> r2 = Widen(coefficients + x + 16);
                Vector128<int> r3 = Widen(coefficients + x + 24);
                Vector128<int> r4 = Widen(coefficients + x + 32);
                Vector128<int> r5 = Widen(coefficients + x + 40);
                Vector128<int> r6 = Widen(coefficients + x + 48);
                Vector128<int> r7 = Widen(coefficients + x + 56);
                Pass(ref r0, ref r1, ref r2, ref r3, ref r4, ref r5, ref r6, ref r7, 1 << (columnShift - 1), columnShift);
                Transpose(ref r0, ref r1, ref r2, ref r3);
                Transpose(ref r4, ref r5, ref r6, ref r7);
                int* columns = workspace + x * 8;
                r0.Store(columns);
                r4.Store(columns + 4);
                r1.Store(columns + 8);
                r5.Store(columns + 12);
                r2.Store(columns + 16);
                r6.Store(columns + 20);
                r3.Store(columns + 24);
                r7.Store(columns + 28);
            }

            const int rowShift = JpegInverseDct.ConstantBits + JpegInverseDct.PassBits + 3;
            const int rounding = (1 << (rowShift - 1)) + (128 << rowShift);
            for (int y = 0; y < 8; y += 4)
            {
                int* rows = workspace + y;
                Vector128<int> c0 = Vector128.Load(rows);
                Vector128<int> c1 = Vector128.Load(rows + 8);
                Vector128<int> c2 = Vector128.Load(rows + 16);
                Vector128<int> c3 = Vector128.Load(rows + 24);
                Vector128<int> c4 = Vector128.Load(rows + 32);
                Vector128<int> c5 = Vector128.Load(rows + 40);
                Vector128<int> c6 = Vector128.Load(rows + 48);
                Vector128<int> c7 = Vector128.Load(rows + 56);
                Pass(ref c0, ref c1, ref c2, ref c3, ref c4, ref c5, ref c6, ref c7, rounding, rowShift);
                Transpose(ref c0, ref c1, ref c2, ref c3);
                Transpose(ref c4, ref c5, ref c6, ref c7);
                Vector128.Narrow(Pack(c0, c4), Pack(c1, c5)).Store(samples + y * 8);
                Vector128.Narrow(Pack(c2, c6), Pack(c3, c7)).Store(samples + y * 8 + 16);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<int> Widen(short* four) => Vector128.WidenLower(Vector128.CreateScalarUnsafe(*(long*)four).AsInt16());

        /// <summary>Eight samples of a row, clamped to a byte.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<ushort> Pack(Vector128<int> left, Vector128<int> right)
        {
            Vector128<int> limit = Vector128.Create(255);
            left = Vector128.Min(Vector128.Max(left, Vector128<int>.Zero), limit);
            right = Vector128.Min(Vector128.Max(right, Vector128<int>.Zero), limit);
            return Vector128.Narrow(left, right).AsUInt16();
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Transpose(ref Vector128<int> r0, ref Vector128<int> r1, ref Vector128<int> r2, ref Vector128<int> r3)
        {
            Vector128<int> low02 = ZipLow(r0, r2);
            Vector128<int> high02 = ZipHigh(r0, r2);
            Vector128<int> low13 = ZipLow(r1, r3);
            Vector128<int> high13 = ZipHigh(r1, r3);
            r0 = ZipLow(low02, low13);
            r1 = ZipHigh(low02, low13);
            r2 = ZipLow(high02, high13);
            r3 = ZipHigh(high02, high13);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<int> ZipLow(Vector128<int> a, Vector128<int> b) =>
            Sse41.IsSupported ? Sse2.UnpackLow(a, b) : AdvSimd.Arm64.ZipLow(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<int> ZipHigh(Vector128<int> a, Vector128<int> b) =>
            Sse41.IsSupported ? Sse2.UnpackHigh(a, b) : AdvSimd.Arm64.ZipHigh(a, b);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Pass(
            ref Vector128<int> r0, ref Vector128<int> r1, ref Vector128<int> r2, ref Vector128<int> r3,
            ref Vector128<int> r4, ref Vector128<int> r5, ref Vector128<int> r6, ref Vector128<int> r7, int rounding, int shift)
        {
            Vector128<int> z1 = (r2 + r6) * Vector128.Create(JpegInverseDct.C0541);
            Vector128<int> even2 = z1 - r6 * Vector128.Create(JpegInverseDct.C1847);
            Vector128<int> even3 = z1 + r2 * Vector128.Create(JpegInverseDct.C0765);
            Vector128<int> round = Vector128.Create(rounding);
            Vector128<int> even0 = Vector128.ShiftLeft(r0 + r4, JpegInverseDct.ConstantBits) + round;
            Vector128<int> even1 = Vector128.ShiftLeft(r0 - r4, JpegInverseDct.ConstantBits) + round;
            Vector128<int> s0 = even0 + even3;
            Vector128<int> s3 = even0 - even3;
            Vector128<int> s1 = even1 + even2;
            Vector128<int> s2 = even1 - even2;

            Vector128<int> z3 = r7 + r3;
            Vector128<int> z4 = r5 + r1;
            Vector128<int> z5 = (z3 + z4) * Vector128.Create(JpegInverseDct.C1175);
            z3 = z5 - z3 * Vector128.Create(JpegInverseDct.C1961);
            z4 = z5 - z4 * Vector128.Create(JpegInverseDct.C0390);
            z1 = (r7 + r1) * Vector128.Create(-JpegInverseDct.C0899);
            Vector128<int> z2 = (r5 + r3) * Vector128.Create(-JpegInverseDct.C2562);
            Vector128<int> odd0 = r7 * Vector128.Create(JpegInverseDct.C0298) + z1 + z3;
            Vector128<int> odd1 = r5 * Vector128.Create(JpegInverseDct.C2053) + z2 + z4;
            Vector128<int> odd2 = r3 * Vector128.Create(JpegInverseDct.C3072) + z2 + z3;
            Vector128<int> odd3 = r1 * Vector128.Create(JpegInverseDct.C1501) + z1 + z4;

            r0 = Vector128.ShiftRightArithmetic(s0 + odd3, shift);
            r7 = Vector128.ShiftRightArithmetic(s0 - odd3, shift);
            r1 = Vector128.ShiftRightArithmetic(s1 + odd2, shift);
            r6 = Vector128.ShiftRightArithmetic(s1 - odd2, shift);
            r2 = Vector128.ShiftRightArithmetic(s2 + odd1, shift);
            r5 = Vector128.ShiftRightArithmetic(s2 - odd1, shift);
            r3 = Vector128.ShiftRightArithmetic(s3 + odd0, shift);
            r4 = Vector128.ShiftRightArithmetic(s3 - odd0, shift);
        }
    }
}
#endif
