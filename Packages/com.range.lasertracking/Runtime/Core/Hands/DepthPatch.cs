using System;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>Distance at a pixel of a depth picture, robust against single bad pixels.</summary>
    public static unsafe class DepthPatch
    {
        /// <summary>Largest radius: an 11×11 patch.</summary>
        public const int MaxRadius = 5;

        /// <summary>
        /// Median of the valid pixels within the gate in the square patch around the pixel (the lower one of an even number); false
        /// when there is none. The patch is cut at the picture's edge. A Depth16 picture; radius 0…5, the published 5×5 patch is 2.
        /// </summary>
        public static bool TryMedian(Image depth, int xPx, int yPx, int radius, double nearMm, double farMm, out double depthMm)
        {
            if (depth.Format != PixelFormat.Depth16 || radius < 0 || radius > MaxRadius)
                throw new ArgumentException("a Depth16 picture and a radius of 0…5 are needed");
            ushort* sorted = stackalloc ushort[(2 * MaxRadius + 1) * (2 * MaxRadius + 1)];
            int count = 0;
            for (int y = Math.Max(0, yPx - radius); y <= Math.Min(depth.Height - 1, yPx + radius); y++)
            {
                var row = (ushort*)(depth.Pixels + (long)y * depth.Stride);
                for (int x = Math.Max(0, xPx - radius); x <= Math.Min(depth.Width - 1, xPx + radius); x++)
                {
                    ushort value = row[x];
                    if (value == 0 || value < nearMm || value > farMm)
                        continue;
                    int i = count++;
                    for (; i > 0 && sorted[i - 1] > value; i--)
                        sorted[i] = sorted[i - 1];
                    sorted[i] = value;
                }
            }

            depthMm = count > 0 ? sorted[(count - 1) / 2] : 0;
            return count > 0;
        }
    }
}
