using System;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// The exact place where four cells meet: the point that is seen along the edges from everywhere around, because every gradient
    /// there stands across the line to it (Förstner and Gülch 1987). Blur that is the same to all sides does not displace it.
    /// </summary>
    internal static class CornerRefiner
    {
        private const int MaxSteps = 8;
        private const double Settled = 0.002;

        /// <summary>Moves a corner to its place; false when it wanders off or has no two edges.</summary>
        /// <param name="plane">Brightness.</param>
        /// <param name="radius">Of the window, px.</param>
        /// <param name="corner">Within a third of the radius of it.</param>
        /// <param name="sigmaPx">Standard deviation along an axis that the gradients' disagreement suggests.</param>
        public static bool TryRefine(LightPlane plane, double radius, ref Vector2D corner, out double sigmaPx)
        {
            sigmaPx = 0;
            Vector2D start = corner;
            int reach = (int)Math.Ceiling(radius);
            for (int step = 0; step < MaxSteps; step++)
            {
                int middleX = (int)Math.Round(corner.X), middleY = (int)Math.Round(corner.Y);
                if (middleX - reach < 1 || middleY - reach < 1 || middleX + reach > plane.Width - 2 || middleY + reach > plane.Height - 2)
                    return false;
                double xx = 0, xy = 0, yy = 0, bx = 0, by = 0, cc = 0, weights = 0;
                for (int y = middleY - reach; y <= middleY + reach; y++)
                {
                    for (int x = middleX - reach; x <= middleX + reach; x++)
                    {
                        double dx = x - corner.X, dy = y - corner.Y, weight = 1 - (dx * dx + dy * dy) / (radius * radius);
                        if (weight <= 0)
                            continue;
                        Gradient(plane, x, y, out double gx, out double gy);
                        double along = gx * dx + gy * dy;
                        weight *= weight;
                        xx += weight * gx * gx;
                        xy += weight * gx * gy;
                        yy += weight * gy * gy;
                        bx += weight * gx * along;
                        by += weight * gy * along;
                        cc += weight * along * along;
                        weights += weight;
                    }
                }

                double determinant = xx * yy - xy * xy, trace = xx + yy;
                if (!(determinant > 0.01 * trace * trace))
                    return false;
                var move = new Vector2D((yy * bx - xy * by) / determinant, (xx * by - xy * bx) / determinant);
                corner += move;
                if ((corner - start).Length > radius)
                    return false;
                if (move.Length > Settled)
                    continue;
                double rest = Math.Max(0, cc - move.X * bx - move.Y * by) / weights;
                sigmaPx = Math.Sqrt(rest * trace / 2 / determinant);
                return true;
            }

            return false;
        }

        /// <summary>Scharr's operator (2000): nearly the same to all directions.</summary>
        private static void Gradient(LightPlane plane, int x, int y, out double gx, out double gy)
        {
            float[] v = plane.Values;
            int at = y * plane.Width + x, up = at - plane.Width, down = at + plane.Width;
            double a = v[up - 1], b = v[up + 1], c = v[down - 1], d = v[down + 1];
            gx = (3 * (b - a + d - c) + 10 * (v[at + 1] - v[at - 1])) / 32.0;
            gy = (3 * (c - a + d - b) + 10 * (v[down] - v[up])) / 32.0;
        }
    }
}
