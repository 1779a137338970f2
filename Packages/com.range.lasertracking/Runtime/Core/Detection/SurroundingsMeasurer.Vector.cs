#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class SurroundingsMeasurer
    {
        /// <summary>The channels of one pixel side by side, in place of the fourth what green differs from red; returns how many pixels are done.</summary>
        private static int AddRisesVector(uint* now, uint* before, int count, double* throughRoom, double* rises, int* levels)
        {
            if (!Avx2.IsSupported)
                return 0;
            Vector256<double> sums = Avx.LoadVector256(rises);
            Vector128<int> sumsBefore = Sse2.LoadVector128(levels);
            for (int i = 0; i < count; i++)
            {
                Vector128<int> here = Sse41.ConvertToVector128Int32(Vector128.CreateScalarUnsafe(now[i]).AsByte());
                Vector128<int> past = Sse41.ConvertToVector128Int32(Vector128.CreateScalarUnsafe(before[i]).AsByte());
                Vector256<double> factors = Avx2.GatherVector256(throughRoom, Sse41.Min(here, past), sizeof(double));
                Vector256<double> shares = Avx.ConvertToVector256Double(here - past) * factors;
                Vector256<double> green = Avx2.Permute4x64(shares, 1 << 6), red = Avx2.Permute4x64(shares, 2 << 6);
                sums += Avx.Blend(shares, Vector256.Abs(green - red), 1 << 3);
                sumsBefore += past;
            }

            Avx.Store(rises, sums);
            Sse2.Store(levels, sumsBefore);
            return count;
        }
    }
}
#endif
