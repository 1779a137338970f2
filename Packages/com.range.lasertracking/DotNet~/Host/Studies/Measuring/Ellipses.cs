using System;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>Whether a point lies in the ellipse that should hold the given share of a normal distribution in the plane.</summary>
    internal static class Ellipses
    {
        public static bool Holds(in Covariance2D covariance, Vector2D error, double share) => SquaredDistance(covariance, error) <= -2 * Math.Log(1 - share);

        /// <summary>Squared Mahalanobis distance; infinite for a covariance that is not positive.</summary>
        public static double SquaredDistance(in Covariance2D c, Vector2D error)
        {
            double determinant = c.XX * c.YY - c.XY * c.XY;
            return determinant > 0
                ? (c.YY * error.X * error.X - 2 * c.XY * error.X * error.Y + c.XX * error.Y * error.Y) / determinant
                : double.PositiveInfinity;
        }
    }
}
