#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Hands
{
    internal static unsafe partial class TorsoKernel
    {
        /// <summary>Whole blocks of 8 bins; returns how many bins are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int AddVector(int* window, int* column, int sign, ref int sum)
        {
            if (!Avx2.IsSupported)
                return 0;
            Vector256<int> signs = Vector256.Create(sign), sums = default;
            int d = 0;
            for (; d + 8 <= DepthBins; d += 8)
            {
                Vector256<int> counts = Avx.LoadVector256(column + d);
                Avx.Store(window + d, Avx.LoadVector256(window + d) + Avx2.Sign(counts, signs));
                sums += counts;
            }

            sum += Vector256.Sum(sums);
            return d;
        }
    }
}
#endif
