using System;

namespace LaserTracking.Detection
{
    /// <summary>Whether what has risen lay a few pixels beside in the frame before: then something moved, and no light began.</summary>
    internal static unsafe class DisplacementMeasurer
    {
        /// <summary>Farthest that things are looked for, working px along each axis.</summary>
        private const int Reach = 4;

        /// <summary>Pixels around the box that have to fit too: light that begins beside something bright must not be taken for that.</summary>
        private const int Margin = 2;

        /// <summary>
        /// The least difference of the candidate and its margin from the frame before, displaced by up to four pixels, through the
        /// difference from it in place: near 1 for new light, little where the same thing was there, elsewhere.
        /// </summary>
        public static double Unexplained(in FrameView view, in Candidate candidate)
        {
            int x0 = Math.Max(Reach, candidate.Left - Margin), x1 = Math.Min(view.Width - 1 - Reach, candidate.Right + Margin);
            int y0 = Math.Max(Reach, candidate.Top - Margin), y1 = Math.Min(view.Height - 1 - Reach, candidate.Bottom + Margin);
            if (x1 < x0 || y1 < y0)
                return 1;
            long inPlace = Difference(view, candidate.Plane, x0, y0, x1, y1, 0, long.MaxValue), least = inPlace;
            for (int dy = -Reach; dy <= Reach; dy++)
            {
                for (int dx = -Reach; dx <= Reach; dx++)
                    least = Math.Min(least, Difference(view, candidate.Plane, x0, y0, x1, y1, dy * view.Width + dx, least));
            }

            return inPlace == 0 ? 1 : least / (double)inPlace;
        }

        /// <summary>Sum of absolute differences; it stops where it exceeds the given one.</summary>
        private static long Difference(in FrameView view, DetectionPlane plane, int x0, int y0, int x1, int y1, int offset, long most)
        {
            long sum = 0;
            for (int y = y0; y <= y1 && sum < most; y++)
            {
                for (int i = y * view.Width + x0; i <= y * view.Width + x1; i++)
                    sum += Math.Abs(FrameView.Level(view.Now[i], plane) - FrameView.Level(view.Before[i + offset], plane));
            }

            return sum;
        }
    }
}
