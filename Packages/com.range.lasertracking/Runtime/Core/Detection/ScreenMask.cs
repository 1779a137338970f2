using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A convex polygon in image pixels outside of which nothing counts; without corners everything is inside.</summary>
    internal sealed class ScreenMask
    {
        private Vector2D[] _corners = Array.Empty<Vector2D>();
        private double _orientation = 1;

        /// <summary>Counts the changes.</summary>
        public int Version { get; private set; }

        public bool IsWholePicture => _corners.Length == 0;

        /// <summary>Either turning direction will do.</summary>
        /// <exception cref="ArgumentException">One or two corners, a corner that is not finite, or no area.</exception>
        public void Set(Vector2D[] cornersPx)
        {
            if (cornersPx == null)
                throw new ArgumentNullException(nameof(cornersPx));
            if (cornersPx.Length == 0)
            {
                Version++;
                _corners = Array.Empty<Vector2D>();
                return;
            }

            double doubleArea = 0;
            for (int i = 0; i < cornersPx.Length; i++)
            {
                if (!cornersPx[i].IsFinite)
                    throw new ArgumentException("corner " + i + " of the screen's polygon is not finite", nameof(cornersPx));
                doubleArea += Vector2D.Cross(cornersPx[i], cornersPx[(i + 1) % cornersPx.Length]);
            }

            if (cornersPx.Length < 3 || Math.Abs(doubleArea) < 1)
                throw new ArgumentException("the screen's polygon needs three corners or more and an area", nameof(cornersPx));
            Version++;
            _corners = (Vector2D[])cornersPx.Clone();
            _orientation = doubleArea > 0 ? 1 : -1;
        }

        /// <summary>Distance in px to the nearest side's line, negative inside. Exact inside; outside, near a corner, a lower bound.</summary>
        public double SignedDistancePx(Vector2D point)
        {
            if (IsWholePicture)
                return double.NegativeInfinity;
            double distance = double.NegativeInfinity;
            for (int i = 0; i < _corners.Length; i++)
            {
                Vector2D a = _corners[i];
                Vector2D side = _corners[(i + 1) % _corners.Length] - a;
                double length = side.Length;
                if (length > 0)
                    distance = Math.Max(distance, -_orientation * Vector2D.Cross(side, point - a) / length);
            }

            return distance;
        }
    }
}
