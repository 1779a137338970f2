using System;

namespace LaserTracking.Geometry
{
    /// <summary>Tests on simple polygons given as a list of corners in order, in either sense of rotation.</summary>
    public static class Polygon2D
    {
        /// <summary>Even-odd rule; points within 1e-12 of an edge count as inside.</summary>
        public static bool Contains(ReadOnlySpan<Vector2D> corners, Vector2D point)
        {
            bool inside = false;
            for (int i = 0, j = corners.Length - 1; i < corners.Length; j = i++)
            {
                Vector2D a = corners[j], b = corners[i];
                if (DistanceToSegment(a, b, point) <= 1e-12)
                    return true;
                if (a.Y > point.Y != b.Y > point.Y && point.X < (b.X - a.X) * (point.Y - a.Y) / (b.Y - a.Y) + a.X)
                    inside = !inside;
            }

            return inside;
        }

        /// <summary>Distance from the point to the nearest edge, inside or outside.</summary>
        public static double DistanceToEdge(ReadOnlySpan<Vector2D> corners, Vector2D point)
        {
            double nearest = double.PositiveInfinity;
            for (int i = 0, j = corners.Length - 1; i < corners.Length; j = i++)
                nearest = Math.Min(nearest, DistanceToSegment(corners[j], corners[i], point));
            return nearest;
        }

        private static double DistanceToSegment(Vector2D a, Vector2D b, Vector2D point)
        {
            Vector2D edge = b - a;
            double lengthSquared = edge.LengthSquared;
            double t = lengthSquared > 0 ? Vector2D.Dot(point - a, edge) / lengthSquared : 0;
            t = Math.Max(0, Math.Min(1, t));
            return (point - a - edge * t).Length;
        }
    }
}
