using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Where a radial lens model stops being a lens: the least undistorted radius r at which the distorted radius r·a(r²)/b(r²) no
    /// longer grows, or at which b has a zero. Beyond it two rays fall on one pixel and a pixel has no one inverse.
    /// </summary>
    internal static class RadialFold
    {
        // Beyond 10 (84° off axis) no picture on a plane reaches; steps far below any lens's features keep a fold from being jumped.
        private const double Farthest = 10;
        private const double Step = 0.01;

        /// <summary>Infinite when the model grows all the way.</summary>
        public static double RadiusOf(double k1, double k2, double k3, double k4, double k5, double k6)
        {
            if (k1 == 0 && k2 == 0 && k3 == 0 && k4 == 0 && k5 == 0 && k6 == 0)
                return double.PositiveInfinity;
            for (int i = 1; i * Step <= Farthest; i++)
            {
                double radius = i * Step;
                if (Grows(radius))
                    continue;
                double inside = radius - Step;
                while (radius - inside > 1e-12 * radius)
                {
                    double middle = (inside + radius) / 2;
                    if (Grows(middle))
                        inside = middle;
                    else
                        radius = middle;
                }

                return inside > 0 ? inside : double.Epsilon;
            }

            return double.PositiveInfinity;

            bool Grows(double r)
            {
                double s = r * r, a = 1 + s * (k1 + s * (k2 + s * k3)), b = 1 + s * (k4 + s * (k5 + s * k6));
                double slope = (a + 2 * s * (k1 + s * (2 * k2 + 3 * s * k3))) * b - 2 * s * a * (k4 + s * (2 * k5 + 3 * s * k6));
                return slope > 0 && b > 0;
            }
        }
    }
}
