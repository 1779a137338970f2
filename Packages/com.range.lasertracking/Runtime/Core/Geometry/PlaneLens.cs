using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// The radial distortion of a lens from one view of a plane: what straight rows of points lack in straightness. The focal length
    /// does not show in a plane and does no harm; the picture's width is taken for it, its middle for the lens's axis. For set-up.
    /// </summary>
    public static class PlaneLens
    {
        /// <summary>A further coefficient must take off this many times its fair share of the squares (an F test near 1 in 10⁴).</summary>
        private const double LeastGain = 15;

        /// <summary>The simplest lens that does justice to the points; null where no distortion is to be seen.</summary>
        /// <param name="planePoints">Where they are in the plane, any unit.</param>
        /// <param name="imagePx">Where they are seen.</param>
        /// <param name="width">Of the picture, px.</param>
        /// <param name="height">The same for its height.</param>
        public static LensCamera? Find(ReadOnlySpan<Vector2D> planePoints, ReadOnlySpan<Vector2D> imagePx, int width, int height)
        {
            if (planePoints.Length < 12)
                return null;
            LensCamera? best = null;
            if (!TryFit(planePoints, imagePx, width, height, 0, out _, out double least))
                return null;
            for (int terms = 1; terms <= 2; terms++)
            {
                if (!TryFit(planePoints, imagePx, width, height, terms, out LensCamera? lens, out double squares))
                    break;
                double fair = squares / (2 * planePoints.Length - 8 - terms);
                if (least - squares < LeastGain * fair)
                    continue;
                best = lens;
                least = squares;
            }

            return best;
        }

        private static bool TryFit(ReadOnlySpan<Vector2D> planePoints, ReadOnlySpan<Vector2D> imagePx, int width, int height, int terms, out LensCamera? lens, out double squares)
        {
            var pinhole = new PinholeCamera(width, width, (width - 1) / 2.0, (height - 1) / 2.0, width, height);
            int count = planePoints.Length;
            Vector2D[] from = new Vector2D[count], to = new Vector2D[count];
            PointNormalization scale = PointNormalization.Of(planePoints);
            for (int i = 0; i < count; i++)
            {
                from[i] = scale.Apply(planePoints[i]);
                to[i] = new Vector2D((imagePx[i].X - pinhole.CenterXPx) / width, (imagePx[i].Y - pinhole.CenterYPx) / width);
            }

            lens = null;
            squares = 0;
            if (!HomographyEstimator.TryFit(from, to, out Homography start, out _))
                return false;
            double[] h = start.ToArray(), parameters = new double[8 + terms];
            for (int i = 0; i < 8; i++)
                parameters[i] = h[i] / h[8];
            if (!LevenbergMarquardt.TryMinimize(Model, parameters, 2 * count, out squares, out _))
                return false;
            lens = new LensCamera(pinhole, Distortion(parameters));
            return true;

            BrownDistortion Distortion(double[] p) => new BrownDistortion(new[] { terms > 0 ? p[8] : 0, terms > 1 ? p[9] : 0, 0 }, 0, 0);

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
