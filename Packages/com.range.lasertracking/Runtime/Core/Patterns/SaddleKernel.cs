using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
#endif

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Smoothing and second derivatives for the search of saddle points, a row a call. Vectors where there are any, with the scalar
    /// form's results to the bit.
    /// </summary>
    internal static unsafe partial class SaddleKernel
    {
        /// <summary>Pixels to either side that smoothing reads.</summary>
        public const int Reach = 4;

        /// <summary>Smoothed levels to one grey level.</summary>
        public const int Scale = 16;

        /// <summary>Binomial of eight steps (σ = √2 px) along a row that has <see cref="Reach"/> more pixels at either end; times 16.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void SmoothAlong(byte* padded, int width, ushort* target)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (Vector256.IsHardwareAccelerated)
                x = SmoothAlongVector(padded, width, target);
#endif
            SmoothAlongScalar(padded, x, width, target);
        }

        public static void SmoothAlongScalar(byte* padded, int start, int width, ushort* target)
        {
            for (int x = start; x < width; x++)
            {
                byte* p = padded + x;
                target[x] = (ushort)((p[0] + p[8] + 8 * (p[1] + p[7]) + 28 * (p[2] + p[6]) + 56 * (p[3] + p[5]) + 70 * p[4] + 8) >> 4);
            }
        }

        /// <summary>The same across nine rows.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void SmoothAcross(ushort** rows, int width, ushort* target)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (Vector256.IsHardwareAccelerated)
                x = SmoothAcrossVector(rows, width, target);
#endif
            SmoothAcrossScalar(rows, x, width, target);
        }

        public static void SmoothAcrossScalar(ushort** rows, int start, int width, ushort* target)
        {
            ushort* a = rows[0], b = rows[1], c = rows[2], d = rows[3], e = rows[4], f = rows[5], g = rows[6], h = rows[7], i = rows[8];
            for (int x = start; x < width; x++)
                target[x] = (ushort)((a[x] + i[x] + 8 * (b[x] + h[x]) + 28 * (c[x] + g[x]) + 56 * (d[x] + f[x]) + 70 * e[x] + 128) >> 8);
        }

        /// <summary>Minus the Hessian's determinant in smoothed levels squared: positive at saddles. The first and the last pixel get 0.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void Respond(ushort* above, ushort* row, ushort* below, int width, int* target)
        {
            target[0] = target[width - 1] = 0;
            int x = 1;
#if NET8_0_OR_GREATER
            if (Vector256.IsHardwareAccelerated)
                x = RespondVector(above, row, below, width, target);
#endif
            RespondScalar(above, row, below, x, width, target);
        }

        public static void RespondScalar(ushort* above, ushort* row, ushort* below, int start, int width, int* target)
        {
            for (int x = start; x < width - 1; x++)
            {
                int twice = 2 * row[x];
                int xx = row[x - 1] + row[x + 1] - twice, yy = above[x] + below[x] - twice;
                int xy = (above[x - 1] + below[x + 1] - above[x + 1] - below[x - 1]) >> 2;
                target[x] = xy * xy - xx * yy;
            }
        }
    }
}
