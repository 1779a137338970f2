using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// A homography fitted to measured points: the direct linear transform as the start, then the least sum of squared distances in
    /// the measured plane, found by Levenberg and Marquardt's method; with its own uncertainty. Immutable. Fitting allocates.
    /// </summary>
    public sealed class HomographyFit
    {
        // How many coordinates' worth the expected standard deviation counts beside the residuals.
        private const double PriorWeight = 4;

        // Parts of the picture, each displaced as a whole by an error of its own.
        private const double Parts = 9;

        private HomographyFit(Homography homography, int count, double rms, double sigma, HomographyUncertainty uncertainty)
        {
            Homography = homography;
            Count = count;
            Rms = rms;
            Sigma = sigma;
            Uncertainty = uncertainty;
        }

        public Homography Homography { get; }

        /// <summary>Points that it was fitted to.</summary>
        public int Count { get; }

        /// <summary>Root mean square distance that remains, in the unit of what was measured.</summary>
        public double Rms { get; }

        /// <summary>Standard deviation of one measured coordinate, from residuals and expectation together.</summary>
        public double Sigma { get; }

        /// <summary>Of the points that it maps to.</summary>
        public HomographyUncertainty Uncertainty { get; }

        /// <summary>The mapping that takes from[i] as near as possible to the measured to[i].</summary>
        /// <param name="from">At least four points that are known well, any unit: where the projector drew.</param>
        /// <param name="to">As many, measured with equal care in every direction, any unit: where the camera saw it.</param>
        /// <param name="expectedSigma">
        /// Expected standard deviation of one measured coordinate, above zero. With four points, which leave no residuals, it alone says
        /// how sure the fit is; the more points, the less it matters (a scaled inverse chi-squared prior of weight 4).
        /// </param>
        /// <param name="fit">Valid only when true is returned.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryFit(ReadOnlySpan<Vector2D> from, ReadOnlySpan<Vector2D> to, double expectedSigma, out HomographyFit? fit, out string reason) =>
            TryFit(from, to, default, expectedSigma, out fit, out reason);

        /// <summary>The same where the points of to were not measured themselves but computed from what was: lens correction stretches noise.</summary>
        /// <param name="from">At least four points that are known well, any unit.</param>
        /// <param name="to">As many, computed from measured ones.</param>
        /// <param name="measuredByTo">Four numbers a point, 2×2 row by row: derivatives of the measured point by to[i]; or empty.</param>
        /// <param name="expectedSigma">As above, of what was measured; RMS and standard deviation are in its unit, too.</param>
        /// <param name="fit">Valid only when true is returned.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        /// <param name="commonSigma">Error of one coordinate that neighbours share, so that many points do not average it out; 0: none.</param>
        public static bool TryFit(ReadOnlySpan<Vector2D> from, ReadOnlySpan<Vector2D> to, ReadOnlySpan<double> measuredByTo, double expectedSigma, out HomographyFit? fit, out string reason, double commonSigma = 0)
        {
            if (!(expectedSigma > 0) || double.IsInfinity(expectedSigma))
                throw new ArgumentException("the expected standard deviation must be above zero", nameof(expectedSigma));
            fit = null;
            if (!HomographyEstimator.TryFit(from, to, out Homography start, out reason))
                return false;

            // All points lie on one side of the horizon, so their centroid does not lie on it: the ninth parameter can be 1.
            int count = from.Length;
            PointNormalization fromScale = PointNormalization.Of(from), toScale = PointNormalization.Of(to);
            double[] h = (toScale.Matrix * start * fromScale.Matrix.Inverse).ToArray(), parameters = h[..8];
            Vector2D[] source = Apply(fromScale, from), target = Apply(toScale, to);
            double[] weights = measuredByTo.ToArray();
            if (!LevenbergMarquardt.TryMinimize(Model, parameters, 2 * count, out double squares, out double[,] covariance))
            {
                reason = "the points do not fix the mapping: too many of them lie on one line";
                return false;
            }

            parameters.CopyTo(h, 0);
            squares /= toScale.Scale * toScale.Scale;
            double variance = (squares + PriorWeight * expectedSigma * expectedSigma) / (2 * count - 8 + PriorWeight);
            double ofFit = variance + CommonVariance(commonSigma, count);
            for (int i = 0; i < 8; i++)
            for (int k = 0; k < 8; k++)
                covariance[i, k] *= ofFit * toScale.Scale * toScale.Scale;
            fit = new HomographyFit(toScale.Matrix.Inverse * new Homography(h) * fromScale.Matrix, count, Math.Sqrt(squares / count), Math.Sqrt(variance),
                new HomographyUncertainty(fromScale, toScale.Scale, h, covariance));
            return true;

            bool Model(double[] p, double[] residuals, double[,]? derivatives)
            {
                Span<double> x = stackalloc double[8], y = stackalloc double[8];
                for (int i = 0; i < source.Length; i++)
                {
                    if (!(p[6] * source[i].X + p[7] * source[i].Y + 1 > 0))
                        return false;
                    Vector2D off = HomographyUncertainty.Derive(p, source[i], x, y) - target[i];
                    double xx = 1, xy = 0, yx = 0, yy = 1;
                    if (weights.Length > 0)
                        (xx, xy, yx, yy) = (weights[4 * i], weights[4 * i + 1], weights[4 * i + 2], weights[4 * i + 3]);
                    residuals[2 * i] = xx * off.X + xy * off.Y;
                    residuals[2 * i + 1] = yx * off.X + yy * off.Y;
                    for (int k = 0; k < 8 && derivatives != null; k++)
                    {
                        derivatives[2 * i, k] = xx * x[k] + xy * y[k];
                        derivatives[2 * i + 1, k] = yx * x[k] + yy * y[k];
                    }
                }

                return true;
            }
        }

        /// <summary>
        /// What a common error of neighbours adds to a coordinate's variance in a fit that takes errors for independent: as if each of nine
        /// parts of the picture were displaced on its own, a ninth of the points with it.
        /// </summary>
        internal static double CommonVariance(double sigma, int points) => sigma * sigma * Math.Max(1, points / Parts);

        private static Vector2D[] Apply(PointNormalization scale, ReadOnlySpan<Vector2D> points)
        {
            var result = new Vector2D[points.Length];
            for (int i = 0; i < result.Length; i++)
                result[i] = scale.Apply(points[i]);
            return result;
        }
    }
}
