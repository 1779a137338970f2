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

        /// <summary>Of two sightings of a board the one with more is to be preferred: measured points, each times its contrast.</summary>
        public double Worth { get; }
    }
}
