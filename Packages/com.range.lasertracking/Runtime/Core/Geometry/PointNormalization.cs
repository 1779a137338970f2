using System;

namespace LaserTracking.Geometry
{
    /// <summary>Moves points' centroid to the origin and scales their mean distance from it to √2 (Hartley 1997).</summary>
    internal readonly struct PointNormalization
    {
        public readonly Vector2D Center;
        public readonly double Scale;

        private PointNormalization(Vector2D center, double scale)
        {
            Center = center;
            Scale = scale;
        }

        public Homography Matrix => new Homography(new[] { Scale, 0, -Scale * Center.X, 0, Scale, -Scale * Center.Y, 0, 0, 1 });

        public static PointNormalization Of(ReadOnlySpan<Vector2D> points)
        {
            Vector2D sum = default;
            foreach (Vector2D p in points)
                sum += p;
            Vector2D center = sum * (1.0 / points.Length);
            double distance = 0;
            foreach (Vector2D p in points)
                distance += (p - center).Length;
            return new PointNormalization(center, distance > 0 ? Math.Sqrt(2) * points.Length / distance : 1);
        }

        public Vector2D Apply(Vector2D p) => (p - Center) * Scale;
    }
}
