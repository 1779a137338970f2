using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>How far a dot moved while one frame saw it, from its shape alone: which end came first a shape does not tell.</summary>
    internal static class DotStreak
    {
        /// <summary>A streak is called one from this length on, px, …</summary>
        private const double MinLengthPx = 3;

        /// <summary>… and when the shape's long variance exceeds the short one by this factor: some lasers are oval.</summary>
        private const double MinRatio = 3;

        /// <summary>
        /// From end to end, px. A line of even light adds length² / 12 to the variance along it. Two short variances of length² are
        /// what round dots show by pixels and noise alone (median of simulated ones).
        /// </summary>
        public static Vector2D From(in Covariance2D shape, out bool isDistinct)
        {
            double mean = (shape.XX + shape.YY) / 2, spread = Math.Sqrt((shape.XX - shape.YY) * (shape.XX - shape.YY) / 4 + shape.XY * shape.XY);
            double shortVariance = Math.Max(0, mean - spread), longVariance = mean + spread;
            double length = Math.Sqrt(Math.Max(0, 12 * (longVariance - shortVariance) - 2 * shortVariance));
            isDistinct = length >= MinLengthPx && longVariance >= MinRatio * shortVariance;
            double angle = 0.5 * Math.Atan2(2 * shape.XY, shape.XX - shape.YY);
            return new Vector2D(length * Math.Cos(angle), length * Math.Sin(angle));
        }
    }
}
