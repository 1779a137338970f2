using System;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>Signed distances to the outlines of zones, metres, negative inside: what smooth edges are drawn with.</summary>
    internal static class ZoneDistance
    {
        public static double Of(TargetZone zone, Vector2D[] corners, Vector2D p)
        {
            switch (zone.Shape)
            {
                case ZoneShape.Ellipse:
                    return Ellipse(p - zone.CenterM, zone.SizeM.X / 2, zone.SizeM.Y / 2);
                case ZoneShape.Rectangle:
                    return Box(p - zone.CenterM, zone.SizeM.X / 2, zone.SizeM.Y / 2);
                default:
                    double edge = Polygon2D.DistanceToEdge(corners, p);
                    return Polygon2D.Contains(corners, p) ? -edge : edge;
            }
        }

        public static double Box(Vector2D d, double halfWidth, double halfHeight)
        {
            double x = Math.Abs(d.X) - halfWidth, y = Math.Abs(d.Y) - halfHeight;
            double outside = new Vector2D(Math.Max(x, 0), Math.Max(y, 0)).Length;
            return outside + Math.Min(Math.Max(x, y), 0);
        }

        // First order: the implicit function over its gradient, exact for circles and near every edge.
        private static double Ellipse(Vector2D d, double a, double b)
        {
            double value = Math.Sqrt(d.X * d.X / (a * a) + d.Y * d.Y / (b * b));
            if (value < 1e-9)
                return -Math.Min(a, b);
            double gx = d.X / (a * a), gy = d.Y / (b * b);
            return value * (value - 1) / Math.Sqrt(gx * gx + gy * gy);
        }
    }
}
