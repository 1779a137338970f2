using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>Saddle points of a picture's brightness, strongest first. For set-up: allocates.</summary>
    internal static class SaddleFinder
    {
        private const int Apart = 3;
        private const int Most = 3000;

        /// <summary>Strength goes with the square of the contrast: these are corners of a fifteenth of the usual contrast.</summary>
        private const double LeastShare = 0.004;

        public static List<ScreenSaddle> Find(LightPlane blurred)
        {
            int width = blurred.Width, height = blurred.Height;
            var strength = new float[width * height];
            float[] values = blurred.Values;
            for (int y = 1; y < height - 1; y++)
            {
                for (int x = 1; x < width - 1; x++)
                {
                    Curvature(values, y * width + x, width, out double xx, out double xy, out double yy);
                    strength[y * width + x] = (float)(xy * xy - xx * yy);
                }
            }

            var found = new List<ScreenSaddle>();
            for (int y = Apart; y < height - Apart; y++)
            {
                for (int x = Apart; x < width - Apart; x++)
                {
                    int at = y * width + x;
                    if (!(strength[at] > 0) || !IsPeak(strength, at, width))
                        continue;
                    Curvature(values, at, width, out double xx, out double xy, out double yy);
                    double gx = (values[at + 1] - values[at - 1]) / 2, gy = (values[at + width] - values[at - width]) / 2, determinant = xx * yy - xy * xy;

                    // Where the gradient vanishes; further away than a pixel it is no saddle but a corner of something else.
                    double dx = -(yy * gx - xy * gy) / determinant, dy = -(xx * gy - xy * gx) / determinant;
                    if (Math.Abs(dx) <= 1.2 && Math.Abs(dy) <= 1.2)
                        found.Add(new ScreenSaddle(new Vector2D(x + dx, y + dy), xx, xy, yy));
                }
            }

            found.Sort((a, b) => b.Strength.CompareTo(a.Strength));
            double least = found.Count == 0 ? 0 : found[Math.Min(found.Count - 1, 40)].Strength * LeastShare;
            int keep = Math.Min(found.Count, Most);
            while (keep > 0 && found[keep - 1].Strength < least)
                keep--;
            found.RemoveRange(keep, found.Count - keep);
            return found;
        }

        private static bool IsPeak(float[] strength, int at, int width)
        {
            float here = strength[at];
            for (int j = -Apart; j <= Apart; j++)
            {
                for (int i = -Apart; i <= Apart; i++)
                {
                    float there = strength[at + j * width + i];
                    if (there > here || (there == here && j * width + i < 0))
                        return false;
                }
            }

            return true;
        }

        private static void Curvature(float[] v, int at, int width, out double xx, out double xy, out double yy)
        {
            xx = v[at - 1] - 2.0 * v[at] + v[at + 1];
            yy = v[at - width] - 2.0 * v[at] + v[at + width];
            xy = (v[at - width - 1] - v[at - width + 1] - v[at + width - 1] + v[at + width + 1]) / 4.0;
        }
    }
}
