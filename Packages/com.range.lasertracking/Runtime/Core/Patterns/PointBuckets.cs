using System;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>Saddle points by place, so that the nearest to a prediction is found without looking at all.</summary>
    internal sealed class PointBuckets
    {
        private const int Size = 32;

        private readonly int[] _next = new int[SaddlePointFinder.MaximumPoints];
        private int[] _first = Array.Empty<int>();
        private int _across, _down;

        /// <summary>Sorts the points of a picture in; their numbers are those of the list.</summary>
        public void Fill(ReadOnlySpan<SaddlePoint> points, int width, int height)
        {
            _across = width / Size + 1;
            _down = height / Size + 1;
            if (_first.Length < _across * _down)
                _first = new int[_across * _down];
            Array.Fill(_first, -1);
            for (int i = points.Length - 1; i >= 0; i--)
            {
                Vector2D p = points[i].PositionPx;
                int bucket = (int)p.Y / Size * _across + (int)p.X / Size;
                _next[i] = _first[bucket];
                _first[bucket] = i;
            }
        }

        /// <summary>Number of the point nearest to a place that is within reach of it, or -1.</summary>
        public int Nearest(ReadOnlySpan<SaddlePoint> points, Vector2D place, double reachPx)
        {
            int best = -1;
            double least = reachPx * reachPx;
            int left = Bucket(place.X - reachPx, _across), right = Bucket(place.X + reachPx, _across);
            int top = Bucket(place.Y - reachPx, _down), bottom = Bucket(place.Y + reachPx, _down);
            for (int row = top; row <= bottom; row++)
            for (int column = left; column <= right; column++)
            {
                for (int i = _first[row * _across + column]; i >= 0; i = _next[i])
                {
                    double distance = (points[i].PositionPx - place).LengthSquared;
                    if (distance < least)
                    {
                        least = distance;
                        best = i;
                    }
                }
            }

            return best;
        }

        private static int Bucket(double coordinate, int count) => Math.Max(0, Math.Min(count - 1, (int)(coordinate / Size)));
    }
}
