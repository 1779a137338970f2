using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Moves a corner to where the edges around it meet: the place whose connection with every pixel near by stands at right angles to
    /// the gradient there (Förstner and Gülch 1987), weighed by a Gaussian window and iterated. Unbiased where the window is
    /// symmetric, which takes a window that sees the edges of this corner only. For corners whose edges are not known yet; where they are,
    /// <see cref="SaddlePointRefiner"/> is several times nearer the truth. Thread-safe.
    /// </summary>
    public static unsafe class CornerRefiner
    {
        /// <summary>Largest half width of the window.</summary>
        public const int LargestHalfWindow = 15;

        private const int Iterations = 40;
        private const double Still = 0.002;

        /// <summary>Half width of the window, in pixels, for corners whose nearest neighbour lies this far away.</summary>
        public static int HalfWindow(double spacingPx) =>
            Math.Max(2, Math.Min(LargestHalfWindow, (int)Math.Round(0.22 * spacingPx)));

        /// <summary>Refines a corner in a <see cref="PixelFormat.Gray8"/> picture.</summary>
        /// <param name="gray">The picture at full resolution.</param>
        /// <param name="halfWindowPx">Half width of the window without the centre, 1 to 15 px.</param>
        /// <param name="positionPx">The corner within about half a window; changed only on success.</param>
        /// <returns>False when it runs away by more than the window, leaves the picture, or there are no two edges.</returns>
        public static bool TryRefine(Image gray, int halfWindowPx, ref Vector2D positionPx) => TryRefine(gray, halfWindowPx, 0, default, ref positionPx);

        /// <summary>The same where the contrast is known to grow across the window, which else draws a blurred corner towards the stronger side.</summary>
        /// <param name="gray">The picture at full resolution.</param>
        /// <param name="halfWindowPx">Half width of the window without the centre, 1 to 15 px.</param>
        /// <param name="middleLevel">The grey in the middle between light and dark everywhere.</param>
        /// <param name="growthPerPx">By which share the contrast grows a pixel.</param>
        /// <param name="positionPx">As above.</param>
        public static bool TryRefine(Image gray, int halfWindowPx, double middleLevel, Vector2D growthPerPx, ref Vector2D positionPx)
        {
            if (gray.Format != PixelFormat.Gray8)
                throw new ArgumentException($"a picture of format {gray.Format} is not grey", nameof(gray));
            if (halfWindowPx < 1 || halfWindowPx > LargestHalfWindow)
                throw new ArgumentOutOfRangeException(nameof(halfWindowPx), "1 to 15");
            int side = 2 * halfWindowPx + 3;
            float* patch = stackalloc float[side * side];
            float* weights = stackalloc float[2 * halfWindowPx + 1];
            for (int i = -halfWindowPx; i <= halfWindowPx; i++)
                weights[i + halfWindowPx] = (float)Math.Exp(-(double)(i * i) / (halfWindowPx * halfWindowPx));
            Vector2D at = positionPx;
            for (int iteration = 0; iteration < Iterations; iteration++)
            {
                if (!TryCut(gray, at, halfWindowPx + 1, patch))
                    return false;
                Level(patch, halfWindowPx + 1, (float)middleLevel, growthPerPx);
                if (!TrySolve(patch, weights, halfWindowPx, out Vector2D move))
                    return false;
                at += move;
                if (!((at - positionPx).Length <= halfWindowPx))
                    return false;
                if (move.Length < Still)
                    break;
            }

            positionPx = at;
            return true;
        }

        /// <summary>The pixels around a place, interpolated so that the place is the patch's centre.</summary>
        private static bool TryCut(Image gray, Vector2D at, int half, float* patch)
        {
            double x = at.X - half, y = at.Y - half;
            int side = 2 * half + 1;
            if (!(x >= 0 && y >= 0 && x + side < gray.Width && y + side < gray.Height))
                return false;
            int left = (int)x, top = (int)y;
            float fx = (float)(x - left), fy = (float)(y - top);
            float a = (1 - fx) * (1 - fy), b = fx * (1 - fy), c = (1 - fx) * fy, d = fx * fy;
            for (int row = 0; row < side; row++)
            {
                byte* p = gray.Pixels + (long)(top + row) * gray.Stride + left;
                byte* q = p + gray.Stride;
                for (int i = 0; i < side; i++)
                    *patch++ = a * p[i] + b * p[i + 1] + c * q[i] + d * q[i + 1];
            }

            return true;
        }

        /// <summary>Divides by the contrast's growth, so that the same contrast is left everywhere.</summary>
        private static void Level(float* patch, int half, float middle, Vector2D growth)
        {
            if (growth.X == 0 && growth.Y == 0)
                return;
            for (int y = -half; y <= half; y++)
            {
                for (int x = -half; x <= half; x++, patch++)
                    *patch = (*patch - middle) * (float)Math.Exp(-growth.X * x - growth.Y * y);
            }
        }

        private static bool TrySolve(float* patch, float* weights, int half, out Vector2D move)
        {
            int side = 2 * half + 3;
            double xx = 0, xy = 0, yy = 0, bx = 0, by = 0;
            for (int y = -half; y <= half; y++)
            {
                float* p = patch + (y + half + 1) * side + half + 1;
                for (int x = -half; x <= half; x++)
                {
                    double gx = p[x + 1] - p[x - 1], gy = p[x + side] - p[x - side];
                    double weight = weights[x + half] * weights[y + half];
                    double wxx = weight * gx * gx, wxy = weight * gx * gy, wyy = weight * gy * gy;
                    xx += wxx;
                    xy += wxy;
                    yy += wyy;
                    bx += wxx * x + wxy * y;
                    by += wxy * x + wyy * y;
                }
            }

            double determinant = xx * yy - xy * xy;
            move = new Vector2D((yy * bx - xy * by) / determinant, (xx * by - xy * bx) / determinant);
            return determinant > 1e-4 * (xx + yy) * (xx + yy) && determinant > 0;
        }
    }
}
