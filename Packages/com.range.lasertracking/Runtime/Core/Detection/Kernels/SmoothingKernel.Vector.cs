#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class SmoothingKernel
    {
        private static int HorizontalVector(uint* source, int width, uint* target)
        {
            int x = 1;
            if (!Avx2.IsSupported)
                return x;
            for (; x + 9 <= width; x += 8)
            {
                Vector256<byte> sides = Avx2.Average(Avx.LoadVector256((byte*)(source + x - 1)), Avx.LoadVector256((byte*)(source + x + 1)));
                Avx.Store((byte*)(target + x), Avx2.Average(sides, Avx.LoadVector256((byte*)(source + x))));
            }

            return x;
        }

        private static int VerticalVector(uint* above, uint* row, uint* below, int width, uint* target)
        {
            int x = 0;
            if (!Avx2.IsSupported)
                return x;
            for (; x + 8 <= width; x += 8)
            {
                Vector256<byte> sides = Avx2.Average(Avx.LoadVector256((byte*)(above + x)), Avx.LoadVector256((byte*)(below + x)));
                Avx.Store((byte*)(target + x), Avx2.Average(sides, Avx.LoadVector256((byte*)(row + x))));
            }

            return x;
        }
    }
}
#endif
