using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// How sharp a picture of a checkerboard is: the width over which the edges between its squares rise from dark to light. Corners
    /// can still be found in a picture that is too blurred to measure with. For set-up, not for the frame loop: it allocates.
    /// </summary>
    public static class EdgeWidth
    {
        // Across an edge this share of a square's side to both sides: clear of the next edge.
        private const double Reach = 0.4;
        private const double StepPx = 0.25;
        private const double LeastContrast = 10;

        /// <summary>
        /// Contrast by steepest slope, px, the median along the rows or along the columns, whichever is wider: a motion blurs one way
        /// only. 0 when no edge can be judged.
        /// </summary>
        /// <param name="gray">Gray8.</param>
        /// <param name="board">Inner corners.</param>
        /// <param name="cornersPx">All of them, in order.</param>
        public static double MedianPx(Image gray, BoardSize board, ReadOnlySpan<Vector2D> cornersPx)
        {
            var along = new double[board.Count];
            var across = new double[board.Count];
            int alongCount = 0, acrossCount = 0;
            for (int row = 0, k = 0; row < board.Rows; row++)
            for (int column = 0; column < board.Columns; column++, k++)
            {
                if (column + 1 < board.Columns && TryMeasure(gray, cornersPx[k], cornersPx[k + 1], out double width))
                    along[alongCount++] = width;
                if (row + 1 < board.Rows && TryMeasure(gray, cornersPx[k], cornersPx[k + board.Columns], out width))
                    across[acrossCount++] = width;
            }

            return Math.Max(Median(along, alongCount), Median(across, acrossCount));
        }

        /// <summary>The edge runs from corner to corner; its profile is taken at right angles in the middle.</summary>
        private static bool TryMeasure(Image gray, Vector2D from, Vector2D to, out double width)
        {
            width = 0;
            Vector2D edge = to - from, middle = (from + to) * 0.5;
            double reach = Reach * edge.Length;
            Vector2D normal = new Vector2D(-edge.Y, edge.X) * (1 / edge.Length);
            if (!TrySample(gray, middle - normal * reach, out double first) || !TrySample(gray, middle + normal * reach, out double last) || Math.Abs(last - first) < LeastContrast)
                return false;
            double steepest = 0;
            for (double t = -reach; t + 1 <= reach; t += StepPx)
            {
                TrySample(gray, middle + normal * t, out double before);
                TrySample(gray, middle + normal * (t + 1), out double after);
                steepest = Math.Max(steepest, (after - before) * Math.Sign(last - first));
            }

            width = Math.Abs(last - first) / steepest;
            return steepest > 0;
        }

        private static unsafe bool TrySample(Image gray, Vector2D at, out double value)
        {
            value = 0;
            int x = (int)Math.Floor(at.X), y = (int)Math.Floor(at.Y);
            if (x < 0 || y < 0 || x + 1 >= gray.Width || y + 1 >= gray.Height)
                return false;
            double fx = at.X - x, fy = at.Y - y;
            byte* above = gray.Pixels + (long)y * gray.Stride + x, below = above + gray.Stride;
            value = (above[0] * (1 - fx) + above[1] * fx) * (1 - fy) + (below[0] * (1 - fx) + below[1] * fx) * fy;
            return true;
        }

        private static double Median(double[] values, int count)
        {
            Array.Sort(values, 0, count);
            return count == 0 ? 0 : values[count / 2];
        }
    }
}
