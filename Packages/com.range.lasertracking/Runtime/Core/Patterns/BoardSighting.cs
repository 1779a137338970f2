using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>A board found in one picture, with all its points.</summary>
    internal sealed class BoardSighting
    {
        private BoardSighting(ScreenPoint[] points, bool isMirrored)
        {
            Points = points;
            IsMirrored = isMirrored;
            foreach (ScreenPoint point in points)
                Worth += point.State == ScreenPointState.Measured ? point.Contrast : 0;
        }

        public ScreenPoint[] Points { get; }

        public bool IsMirrored { get; }

        /// <summary>Of two sightings of a board the one with more is to be preferred: measured points, each times its contrast.</summary>
        public double Worth { get; }

        /// <summary>Measures in the full picture what was recognised in a reduced one; null where that does not hold together.</summary>
        public static BoardSighting? TryMeasure(ScreenBoardDecoder decoder, LightPlane full, int factor)
        {
            var known = new Dictionary<(int, int), Vector2D>();
            foreach (KeyValuePair<(int Column, int Row), Vector2D> point in decoder.Points)
                known.Add(point.Key, (point.Value + new Vector2D(0.5, 0.5)) * factor - new Vector2D(0.5, 0.5));
            ScreenPoint[]? points = new ScreenPointLocator(decoder.Board, full, decoder.IsUpright).Locate(known);
            return points == null ? null : new BoardSighting(points, decoder.IsMirrored);
        }
    }
}
