using System;

namespace LaserTracking.Detection
{
    /// <summary>Looks at what happens around a candidate: whether it is alone, whether its neighbourhood is at rest, what colour rose.</summary>
    internal static unsafe class SurroundingsMeasurer
    {
        /// <summary>Share of the ring around the box in which the rise is at least half the candidate's own.</summary>
        public static double RingShare(in FrameView view, in Candidate candidate)
        {
            int size = Math.Max(candidate.Right - candidate.Left, candidate.Bottom - candidate.Top) + 1;
            int inner = Math.Max(3, size / 2), outer = inner + Math.Max(6, size / 2);
            int threshold = Math.Max(1, (candidate.PeakRelativeRise + 1) / 2);
            int risen = 0, count = 0;
            int x0 = Math.Max(0, candidate.Left - outer), x1 = Math.Min(view.Width - 1, candidate.Right + outer);
            int y0 = Math.Max(0, candidate.Top - outer), y1 = Math.Min(view.Height - 1, candidate.Bottom + outer);
            for (int y = y0; y <= y1; y++)
            {
                bool isRowInside = y >= candidate.Top - inner && y <= candidate.Bottom + inner;
                for (int x = x0; x <= x1; x++)
                {
                    if (isRowInside && x >= candidate.Left - inner && x <= candidate.Right + inner)
                    {
                        x = Math.Min(x1, candidate.Right + inner);
                        continue;
                    }

                    count++;
                    if (view.RelativeRise(y * view.Width + x, candidate.Plane) >= threshold)
                        risen++;
                }
            }

            return count == 0 ? 0 : (double)risen / count;
        }

        /// <summary>Share of every second pixel of every second row within the radius, the dot and its halo left out, that changed.</summary>
        public static double MotionShare(in FrameView view, in Candidate candidate, int radius, double noise)
        {
            int size = Math.Max(candidate.Right - candidate.Left, candidate.Bottom - candidate.Top) + 1;
            int inner = Math.Max(4, size);
            int threshold = Math.Max(candidate.PeakRise / 6, (int)(4 * noise) + 2);
            int x0 = Math.Max(0, candidate.Left - radius), x1 = Math.Min(view.Width - 1, candidate.Right + radius);
            int y0 = Math.Max(0, candidate.Top - radius), y1 = Math.Min(view.Height - 1, candidate.Bottom + radius);
            int changed = 0, count = 0;
            for (int y = y0; y <= y1; y += 2)
            {
                bool isRowInside = y >= candidate.Top - inner && y <= candidate.Bottom + inner;
                for (int x = x0; x <= x1; x += 2)
                {
                    if (isRowInside && x >= candidate.Left - inner && x <= candidate.Right + inner)
                        continue;
                    count++;
                    int change = view.Change(y * view.Width + x, candidate.Plane);
                    if (change > threshold || change < -threshold)
                        changed++;
                }
            }

            return count == 0 ? 0 : (double)changed / count;
        }

        /// <summary>
        /// Each channel's rise since the last frame through its own headroom there, summed over the box and 60 % more: the rim tells
        /// the colour where the core is white, and a saturated background lowers no channel's say.
        /// </summary>
        public static void ColorRise(in FrameView view, ref Candidate candidate)
        {
            int marginX = 1 + (candidate.Right - candidate.Left + 1) * 3 / 10, marginY = 1 + (candidate.Bottom - candidate.Top + 1) * 3 / 10;
            int x0 = Math.Max(0, candidate.Left - marginX), x1 = Math.Min(view.Width - 1, candidate.Right + marginX);
            int y0 = Math.Max(0, candidate.Top - marginY), y1 = Math.Min(view.Height - 1, candidate.Bottom + marginY);
            double red = 0, green = 0;
            for (int y = y0; y <= y1; y++)
            {
                for (int x = x0; x <= x1; x++)
                {
                    uint now = view.Now[y * view.Width + x], before = view.Before[y * view.Width + x];
                    green += Share((int)(now >> 8 & 255), (int)(before >> 8 & 255));
                    red += Share((int)(now >> 16 & 255), (int)(before >> 16 & 255));
                }
            }

            candidate.RedRise = red;
            candidate.GreenRise = green;
        }

        private static double Share(int now, int before) => (now - before) / (double)(255 - before + 8);
    }
}
