#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Hands
{
    internal static unsafe partial class DepthGridKernel
    {
        private const int CacheLineBytes = 64;

        /// <summary>Asks memory for a row to come: no processor foresees what follows a row's end.</summary>
        public static void Announce(byte* row, int bytes)
        {
            if (!Sse.IsSupported)
                return;
            for (int at = 0; at < bytes; at += CacheLineBytes)
                Sse.Prefetch0(row + at);
        }

        /// <summary>Whole blocks of 8 cells, not the row's last cell; returns how many are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int RowVector(ushort* top, ushort* bottom, int cells, int stepPx, int first, int second, int lowest, int highest, int band, float* z, bool* lost)
        {
            if (!Avx2.IsSupported)
                return 0;
            Vector256<int> places = Avx2.MultiplyLow(Vector256.Create(0, 1, 2, 3, 4, 5, 6, 7), Vector256.Create(stepPx));
            int cell = 0;

            // What is gathered reaches a pixel to the right of those meant.
            for (; cell + 8 < cells; cell += 8)
            {
                int left = cell * stepPx + first, right = cell * stepPx + second;
                Vector256<int> a = Pixels(top + left, places), b = Pixels(top + right, places), c = Pixels(bottom + left, places), d = Pixels(bottom + right, places);
                Vector256<int> isLost = Avx2.CompareEqual(a | b | c | d, Vector256<int>.Zero);
                Vector128<short> lostWords = Sse2.PackSignedSaturate(isLost.GetLower(), isLost.GetUpper());
                Sse2.StoreScalar((long*)(lost + cell), (Sse2.PackSignedSaturate(lostWords, lostWords).AsByte() & Vector128.Create((byte)1)).AsInt64());
                a = Near(a, lowest);
                b = Near(b, lowest);
                c = Near(c, lowest);
                d = Near(d, lowest);
                Vector256<int> nearest = Avx2.Min(Avx2.Min(a, b), Avx2.Min(c, d)), sum = default, count = default;
                Vector256<int> limit = nearest + Vector256.Create(band);
                Add(a, limit, ref sum, ref count);
                Add(b, limit, ref sum, ref count);
                Add(c, limit, ref sum, ref count);
                Add(d, limit, ref sum, ref count);
                Vector256<float> mean = Avx.Divide(Avx.ConvertToVector256Single(sum), Avx.ConvertToVector256Single(count));
                Avx.Store(z + cell, Avx.AndNot(Avx2.CompareGreaterThan(nearest, Vector256.Create(highest)).AsSingle(), mean));
            }

            return cell;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<int> Pixels(ushort* row, Vector256<int> places) =>
            Avx2.GatherVector256((int*)row, places, sizeof(ushort)) & Vector256.Create(0xFFFF);

        /// <summary>What is nearer than the lowest is as far as can be, and still may have a band added.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<int> Near(Vector256<int> pixels, int lowest) =>
            pixels | Avx2.CompareGreaterThan(Vector256.Create(lowest), pixels) & Vector256.Create(0x3FFFFFFF);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Add(Vector256<int> pixels, Vector256<int> limit, ref Vector256<int> sum, ref Vector256<int> count)
        {
            Vector256<int> within = Avx2.CompareGreaterThan(limit + Vector256<int>.One, pixels);
            sum += pixels & within;
            count -= within;
        }
    }
}
#endif
