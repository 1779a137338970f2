using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// The radial distortion of a lens from one view of a plane: what straight rows of points lack in straightness; with the joint
    /// uncertainty of lens and homography. The focal length does not show in a plane and does no harm; the picture's width is taken
    /// for it, its middle for the lens's axis. For set-up. Immutable.
    /// </summary>
    public sealed class PlaneLens
    {
        /// <summary>Radial coefficients, k1 and k2, that are found or said to be nought.</summary>
        public const int Coefficients = 2;

        /// <summary>A further coefficient must take off this many times its fair share of the squares (an F test near 1 in 10⁴).</summary>
        private const double LeastGain = 15;

        private const int LeastPoints = 12, Parameters = 8 + Coefficients;

        // How many coordinates' worth the expected standard deviation counts beside the residuals, as in HomographyFit.
        private const double PriorWeight = 4;

        private PlaneLens(LensCamera camera, bool isFound, HomographyUncertainty uncertainty)
        {
            Camera = camera;
            IsFound = isFound;
            Uncertainty = uncertainty;
        }

        /// <summary>The simplest lens that does justice to the points, without distortion where none is to be seen; its focal length is nominal.</summary>
        public LensCamera Camera { get; }

        /// <summary>Distortion is to be seen.</summary>
        public bool IsFound { get; }

        /// <summary>
        /// Of plane to image px free of distortion, jointly with both coefficients. A coefficient that is held at nought may be wrong, too:
        /// what freeing it would change counts as an error of one standard deviation.
        /// </summary>
        public HomographyUncertainty Uncertainty { get; }

        /// <param name="planePoints">Where they are in the plane, any unit.</param>
        /// <param name="imagePx">Where they are seen.</param>
        /// <param name="width">Of the picture, px.</param>
        /// <param name="height">The same for its height.</param>
        /// <param name="expectedSigmaPx">How well one coordinate is expected to be measured, above zero; see <see cref="HomographyFit"/>.</param>
        /// <param name="lens">Valid only when true is returned.</param>
        /// <param name="commonSigmaPx">Error that neighbours share; see <see cref="HomographyFit"/>.</param>
        /// <returns>False with fewer than twelve points, or when they fix no homography.</returns>
        public static bool TryFind(ReadOnlySpan<Vector2D> planePoints, ReadOnlySpan<Vector2D> imagePx, int width, int height, double expectedSigmaPx, out PlaneLens? lens, double commonSigmaPx = 0)
        {
            lens = null;
            if (planePoints.Length < LeastPoints || !TryFit(planePoints, imagePx, width, height, 0, out double[] best, out double[,] inverse, out double least))
                return false;
            double[] fullest = best;
            int taken = 0, freedom = 2 * planePoints.Length - 8;
            for (int terms = 1; terms <= Coefficients; terms++)
            {
                if (!TryFit(planePoints, imagePx, width, height, terms, out fullest, out double[,] found, out double squares))
                    break;
                double fair = squares / (freedom - terms);
                if (least - squares < LeastGain * fair)
                    continue;
                (best, inverse, least, taken) = (fullest, found, squares, terms);
            }

            double variance = (least + PriorWeight * expectedSigmaPx * expectedSigmaPx / ((double)width * width)) / (freedom - taken + PriorWeight);
            variance += HomographyFit.CommonVariance(commonSigmaPx / width, planePoints.Length);
            var covariance = new double[Parameters, Parameters];
            for (int i = 0; i < Parameters; i++)
            for (int k = 0; k < Parameters; k++)
            {
                covariance[i, k] = (fullest[i] - best[i]) * (fullest[k] - best[k]);
                if (i < 8 + taken && k < 8 + taken)
                    covariance[i, k] += variance * inverse[i, k];
            }

            double[] h = { best[0], best[1], best[2], best[3], best[4], best[5], best[6], best[7], 1 };
            var uncertainty = new HomographyUncertainty(PointNormalization.Of(planePoints), 1.0 / width, h, covariance);
            lens = new PlaneLens(new LensCamera(Nominal(width, height), Distortion(best)), taken > 0, uncertainty);
            return true;
        }

        private static PinholeCamera Nominal(int width, int height) => new PinholeCamera(width, width, (width - 1) / 2.0, (height - 1) / 2.0, width, height);

        private static BrownDistortion Distortion(double[] p) => new BrownDistortion(new[] { p.Length > 8 ? p[8] : 0, p.Length > 9 ? p[9] : 0, 0 }, 0, 0);

        /// <summary>Homography between normalised points, then so many coefficients; the rest of the ten parameters nought.</summary>
        private static bool TryFit(ReadOnlySpan<Vector2D> planePoints, ReadOnlySpan<Vector2D> imagePx, int width, int height, int terms, out double[] parameters, out double[,] inverse, out double squares)
        {
            PinholeCamera pinhole = Nominal(width, height);
            int count = planePoints.Length;
            Vector2D[] from = new Vector2D[count], to = new Vector2D[count];
            PointNormalization scale = PointNormalization.Of(planePoints);
            for (int i = 0; i < count; i++)
            {
                from[i] = scale.Apply(planePoints[i]);
                to[i] = new Vector2D((imagePx[i].X - pinhole.CenterXPx) / width, (imagePx[i].Y - pinhole.CenterYPx) / width);
            }

            parameters = new double[Parameters];
            inverse = new double[0, 0];
            squares = 0;
            if (!HomographyEstimator.TryFit(from, to, out Homography start, out _))
                return false;
            double[] h = start.ToArray(), free = new double[8 + terms];
            for (int i = 0; i < 8; i++)
                free[i] = h[i] / h[8];
            if (!LevenbergMarquardt.TryMinimize(Model, free, 2 * count, out squares, out inverse))
                return false;
            free.CopyTo(parameters, 0);
            return true;

            bool Model(double[] p, double[] residuals, double[,]? derivatives)
            {
                if (!(Math.Abs(p[p.Length - 1]) < 1e6))
                    return false;
                BrownDistortion distortion = Distortion(p);
                Span<double> x = stackalloc double[8], y = stackalloc double[8], byRay = stackalloc double[4], byCoefficients = stackalloc double[10];
                for (int i = 0; i < from.Length; i++)
                {
                    if (!(p[6] * from[i].X + p[7] * from[i].Y + 1 > 0))
                        return false;
                    Vector2D off = distortion.Distort(HomographyUncertainty.Derive(p, from[i], x, y), byRay, byCoefficients) - to[i];
                    residuals[2 * i] = off.X;
                    residuals[2 * i + 1] = off.Y;
                    for (int k = 0; k < 8 && derivatives != null; k++)
                    {
                        derivatives[2 * i, k] = byRay[0] * x[k] + byRay[1] * y[k];
                        derivatives[2 * i + 1, k] = byRay[2] * x[k] + byRay[3] * y[k];
                    }

                    for (int k = 0; k < terms && derivatives != null; k++)
                    {
                        derivatives[2 * i, 8 + k] = byCoefficients[k];
                        derivatives[2 * i + 1, 8 + k] = byCoefficients[5 + k];
                    }
                }

                return true;
            }
        }
    }
}
