using System;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>How much of a normal distribution over a target's plane falls into one zone.</summary>
    public static class ZoneProbability
    {
        private const int Samples = 987;
        private static readonly Vector2D[] Normal = CreateSamples();

        /// <summary>
        /// Probability 0…1 that a point with the given mean and covariance (m²) lies in the zone, in the target's order of
        /// precedence. Counted over 987 fixed points spread evenly under the normal distribution: within about 0.01, the same on
        /// every run. A covariance of zero gives 1 or 0; one with NaN gives 0. No allocation.
        /// </summary>
        public static double Of(TargetDefinition target, int zone, Vector2D meanM, Covariance2D covarianceM2)
        {
            if (double.IsNaN(covarianceM2.XX + covarianceM2.XY + covarianceM2.YY))
                return 0;

            // Cholesky; a covariance that rounding has made slightly indefinite is treated as a line.
            double a = Math.Sqrt(Math.Max(0, covarianceM2.XX));
            double b = a > 0 ? covarianceM2.XY / a : 0;
            double c = Math.Sqrt(Math.Max(0, covarianceM2.YY - b * b));
            if (a == 0 && c == 0)
                return target.ZoneAt(meanM) == zone ? 1 : 0;
            int inside = 0;
            foreach (Vector2D n in Normal)
            {
                if (target.ZoneAt(new Vector2D(meanM.X + a * n.X, meanM.Y + b * n.X + c * n.Y)) == zone)
                    inside++;
            }

            return inside / (double)Samples;
        }

        // A Fibonacci spiral: equal shares of probability by radius, golden-angle steps in direction.
        private static Vector2D[] CreateSamples()
        {
            var samples = new Vector2D[Samples];
            double goldenAngle = Math.PI * (3 - Math.Sqrt(5));
            for (int i = 0; i < Samples; i++)
            {
                double radius = Math.Sqrt(-2 * Math.Log(1 - (i + 0.5) / Samples));
                samples[i] = new Vector2D(radius * Math.Cos(i * goldenAngle), radius * Math.Sin(i * goldenAngle));
            }

            return samples;
        }
    }
}
