#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    internal static unsafe partial class PatchKernel
    {
        private const int CacheLineBytes = 64;

        /// <summary>Asks memory for all rows of a patch at once: runs a picture's line apart are nothing that a processor foresees.</summary>
        private static void Announce(PictureView source, long first, int top, int factor, int bytes)
        {
            if (!Sse.IsSupported)
                return;
            for (int y = 0; y < Window; y++)
            {
                byte* row = source.Row((top + y) * factor) + first;
                for (int at = 0; at < bytes + CacheLineBytes; at += CacheLineBytes)
                    Sse.Prefetch0(row + at);
            }
        }

        /// <summary>A whole row of a patch, its end twice; returns how many pixels are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int ReadRowVector(byte* row, int bytes, int factor, byte* to)
        {
            if (!Avx2.IsSupported)
                return 0;
            if (factor == 1)
            {
                Avx.Store(to, Samples(row, bytes));
                Avx.Store(to + Window - 32, Samples(row + (Window - 32) * bytes, bytes));
                return Window;
            }

            Sse2.Store(to, Means(row, bytes));
            Sse2.Store(to + 16, Means(row + 32 * bytes, bytes));
            Sse2.Store(to + Window - 16, Means(row + 2 * (Window - 16) * bytes, bytes));
            return Window;
        }

        /// <summary>Of 32 pixels the first byte each.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<byte> Samples(byte* row, int bytes)
        {
            if (bytes == 1)
                return Avx.LoadVector256(row);
            if (bytes == 2)
            {
                Vector256<short> low = Vector256.Create((short)0xFF);
                Vector256<byte> packed = Avx2.PackUnsignedSaturate(Avx.LoadVector256((short*)row) & low, Avx.LoadVector256((short*)row + 16) & low);
                return Avx2.Permute4x64(packed.AsUInt64(), 0xD8).AsByte();
            }

            var pixels = (uint*)row;
            Vector256<uint> lowest = Vector256.Create(0xFFu);
            return LevelVectors.Pack(Avx.LoadVector256(pixels) & lowest, Avx.LoadVector256(pixels + 8) & lowest,
                Avx.LoadVector256(pixels + 16) & lowest, Avx.LoadVector256(pixels + 24) & lowest);
        }

        /// <summary>Of 16 pairs of pixels the rounded means.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<byte> Means(byte* row, int bytes)
        {
            Vector256<short> sums = Avx2.MultiplyAddAdjacent(Samples(row, bytes), Vector256.Create((sbyte)1));
            Vector256<short> means = Avx2.ShiftRightLogical(sums + Vector256.Create((short)1), 1);
            return Sse2.PackUnsignedSaturate(means.GetLower(), means.GetUpper());
        }

        /// <summary>False where the processor lacks 256-bit vectors.</summary>
        private static bool SumUpVector(byte* patch, int* columns, int* rows)
        {
            if (!Avx2.IsSupported)
                return false;
            Vector256<short> left = default, middle = default, right = default;
            for (int y = 0; y < Window; y++)
            {
                byte* row = patch + y * Window;
                Vector256<long> sums = Avx2.SumAbsoluteDifferences(Avx.LoadVector256(row + Reach), Vector256<byte>.Zero).AsInt64();
                rows[y] = (int)Vector256.Sum(sums);
                if (y < Reach || y >= Reach + Size)
                    continue;
                left += Avx2.ConvertToVector256Int16(row);
                middle += Avx2.ConvertToVector256Int16(row + 16);
                right += Avx2.ConvertToVector256Int16(row + Window - 16);
            }

            Store(left, columns);
            Store(middle, columns + 16);
            Store(right, columns + Window - 16);
            return true;
        }

        private static void Store(Vector256<short> sums, int* to)
        {
            Avx.Store(to, Avx2.ConvertToVector256Int32(sums.GetLower()));
            Avx.Store(to + 8, Avx2.ConvertToVector256Int32(sums.GetUpper()));
        }

        /// <summary>All displacements side by side, each sum in the scalar form's order. False where the processor lacks 256-bit vectors.</summary>
        private static bool CompareVector(double* slopes, double* expected, double* differences)
        {
            if (!Avx.IsSupported)
                return false;
            Vector256<double> a = default, b = default, c = default;
            for (int i = 0; i < Size; i++)
            {
                Vector256<double> here = Vector256.Create(expected[i]);
                a += Vector256.Abs(Avx.LoadVector256(slopes + i) - here);
                b += Vector256.Abs(Avx.LoadVector256(slopes + i + 4) - here);
                c += Vector256.Abs(Avx.LoadVector256(slopes + i + 8) - here);
            }

            Avx.Store(differences, a);
            Avx.Store(differences + 4, b);
            Avx.Store(differences + 8, c);
            return true;
        }
    }
}
#endif
