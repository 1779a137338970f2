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

        /// <summary>The corners of the smallest convex polygon around the points, clockwise in a picture (Andrew 1979). Allocates.</summary>
        public static Vector2D[] ConvexHull(ReadOnlySpan<Vector2D> points)
        {
            Vector2D[] sorted = points.ToArray();
            Array.Sort(sorted, (a, b) => a.X != b.X ? a.X.CompareTo(b.X) : a.Y.CompareTo(b.Y));
            var hull = new Vector2D[2 * sorted.Length + 1];
            int count = 0;
            for (int pass = 0; pass < 2; pass++)
            {
                int start = count;
                foreach (Vector2D p in sorted)
                {
                    while (count >= start + 2 && Vector2D.Cross(hull[count - 1] - hull[count - 2], p - hull[count - 1]) <= 0)
                        count--;
                    hull[count++] = p;
                }

                // The last point of one chain is the first of the other.
                count = Math.Max(start, count - 1);
                Array.Reverse(sorted);
            }

            return hull[..count];
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
