using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>A board found in one picture, with all its points.</summary>
    internal sealed class BoardSighting
    {
        public BoardSighting(ScreenBoard board, ScreenPoint[] points, bool isMirrored)
        {
            Board = board;
            Points = points;
            IsMirrored = isMirrored;
            foreach (ScreenPoint point in points)
            {
                if (point.State != ScreenPointState.Measured)
                    continue;
                Measured++;
                Worth += point.Contrast;
            }
        }

        public ScreenBoard Board { get; }

        public ScreenPoint[] Points { get; }

        public bool IsMirrored { get; }

        /// <summary>Points of it that were measured.</summary>
        public int Measured { get; }

        /// <summary>Median displacement against another sighting of the same board, px; zero where fewer than ten points are common.</summary>
        public Vector2D MovedFrom(BoardSighting other)
        {
            List<double> x = new List<double>(), y = new List<double>();
            for (int i = 0; i < Points.Length; i++)
            {
                if (Points[i].State != ScreenPointState.Measured || other.Points[i].State != ScreenPointState.Measured)
                    continue;
                x.Add(Points[i].ImagePx.X - other.Points[i].ImagePx.X);
                y.Add(Points[i].ImagePx.Y - other.Points[i].ImagePx.Y);
            }

            x.Sort();
            y.Sort();
            return x.Count < 10 ? default : new Vector2D(x[x.Count / 2], y[y.Count / 2]);
        }

        /// <summary>Of two sightings of a board the one with more is to be preferred: measured points, each times its contrast.</summary>
        public double Worth { get; }
    }
}
