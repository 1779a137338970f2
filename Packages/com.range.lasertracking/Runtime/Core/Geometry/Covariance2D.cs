using System;

namespace LaserTracking.Geometry
{
    /// <summary>The symmetric 2×2 covariance of a point in a plane; the unit is the square of the point's unit.</summary>
    public readonly struct Covariance2D
    {
        public readonly double XX;
        public readonly double XY;
        public readonly double YY;

        public Covariance2D(double xx, double xy, double yy)
        {
            XX = xx;
            XY = xy;
            YY = yy;
        }

        public static Covariance2D Isotropic(double sigma) => new Covariance2D(sigma * sigma, 0, sigma * sigma);

        /// <summary>The root of half the trace: the standard deviation along one axis when the ellipse is a circle.</summary>
        public double Sigma => Math.Sqrt(Math.Max(0, (XX + YY) / 2));

        /// <summary>Of the sum of two independent errors.</summary>
        public static Covariance2D operator +(Covariance2D a, Covariance2D b) => new Covariance2D(a.XX + b.XX, a.XY + b.XY, a.YY + b.YY);

        /// <summary>J C Jᵀ for the 2×2 matrix J = [[a, b], [c, d]]: the covariance after a (linearised) mapping.</summary>
        public Covariance2D Transform(double a, double b, double c, double d) => new Covariance2D(
            a * a * XX + 2 * a * b * XY + b * b * YY,
            a * c * XX + (a * d + b * c) * XY + b * d * YY,
            c * c * XX + 2 * c * d * XY + d * d * YY);
    }
}
