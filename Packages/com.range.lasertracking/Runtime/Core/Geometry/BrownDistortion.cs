using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Lens distortion after Brown (1966) and Conrady (1919), radial part rational with eight coefficients in all (Claus and Fitzgibbon
    /// 2005); with k4 = k5 = k6 = 0 the usual five. Works on rays normalised to z = 1. Inverted exactly by Newton's method: the usual
    /// few steps of fixed-point iteration are off by pixels with strong lenses. Immutable, allocates nothing when it maps.
    /// </summary>
    public sealed class BrownDistortion
    {
        private const int MaxSteps = 40;
        private const double Converged = 1e-28;
        private readonly double _k1, _k2, _k3, _k4, _k5, _k6, _p1, _p2, _cross;
        private readonly Vector2D _center;

        /// <param name="k">Radial: k1 to k3 of the numerator and k4 to k6 of the denominator; three or six finite numbers.</param>
        /// <param name="p1">Tangential.</param>
        /// <param name="p2">Tangential.</param>
        /// <param name="maxRadius">Largest undistorted radius at which the model holds, above zero; null: up to where it folds back.</param>
        /// <param name="center">Where the lens's axis pierces the plane z = 1.</param>
        /// <param name="cross">Factor of the mixed tangential terms p·x·y: 2, but 1 in the Azure Kinect's early "Rational 6KT" model.</param>
        /// <exception cref="ArgumentException">Another count of coefficients, or one that is not finite.</exception>
        public BrownDistortion(ReadOnlySpan<double> k, double p1, double p2, double? maxRadius = null, Vector2D center = default, double cross = 2)
        {
            if (k.Length != 3 && k.Length != 6)
                throw new ArgumentException("a lens has three or six radial coefficients");
            double sum = p1 + p2 + center.X + center.Y + cross;
            foreach (double value in k)
                sum += value;
            if (double.IsNaN(sum) || double.IsInfinity(sum))
                throw new ArgumentException("a lens's coefficients must be finite");
            if (maxRadius is double radius && !(radius > 0))
                throw new ArgumentException("the largest radius must be above zero");
            _k1 = k[0];
            _k2 = k[1];
            _k3 = k[2];
            if (k.Length == 6)
            {
                _k4 = k[3];
                _k5 = k[4];
                _k6 = k[5];
            }

            _p1 = p1;
            _p2 = p2;
            _center = center;
            _cross = cross;
            MaxRadius = maxRadius ?? RadialFold.RadiusOf(_k1, _k2, _k3, _k4, _k5, _k6);
        }

        /// <summary>A lens that does not distort.</summary>
        public static BrownDistortion None { get; } = new BrownDistortion(new double[3], 0, 0);

        /// <summary>Largest undistorted radius at which the model holds: as stated, or that from which it folds back; may be infinite.</summary>
        public double MaxRadius { get; }

        /// <param name="coefficients">k1, k2, p1, p2, k3 or k1, k2, p1, p2, k3, k4, k5, k6: OpenCV's order.</param>
        /// <exception cref="ArgumentException">Neither five nor eight numbers, or one that is not finite.</exception>
        public static BrownDistortion FromOpenCv(ReadOnlySpan<double> coefficients)
        {
            if (coefficients.Length != 5 && coefficients.Length != 8)
                throw new ArgumentException(FormattableString.Invariant($"a lens has five or eight coefficients, not {coefficients.Length}"));
            Span<double> k = stackalloc double[6];
            k.Clear();
            k[0] = coefficients[0];
            k[1] = coefficients[1];
            coefficients.Slice(4).CopyTo(k.Slice(2));
            return new BrownDistortion(k, coefficients[2], coefficients[3]);
        }

        /// <summary>k1, k2, p1, p2, k3, k4, k5, k6: OpenCV's order, always all eight.</summary>
        /// <exception cref="InvalidOperationException">A lens with a centre of its own or a single mixed term has no such form.</exception>
        public double[] ToOpenCv()
        {
            if (_cross != 2 || !_center.Equals(default))
                throw new InvalidOperationException("this lens is not of the common Brown-Conrady form");
            return new[] { _k1, _k2, _p1, _p2, _k3, _k4, _k5, _k6 };
        }

        /// <summary>Where the lens puts a ray; false beyond the radius up to which the model holds.</summary>
        public bool TryDistort(Vector2D ray, out Vector2D distorted)
        {
            distorted = Distort(ray, out _, out _, out _, out _);
            return IsInside(ray) && distorted.IsFinite;
        }

        /// <summary>The ray that the lens put here; false where there is none or the search does not settle.</summary>
        public bool TryUndistort(Vector2D distorted, out Vector2D ray) => TryUndistort(distorted, distorted, out ray);

        /// <summary>The same from a known place near the result: fewer steps.</summary>
        internal bool TryUndistort(Vector2D distorted, Vector2D start, out Vector2D ray)
        {
            ray = start;
            Vector2D error = Distort(ray, out double xx, out double xy, out double yx, out double yy) - distorted;
            for (int step = 0; step < MaxSteps && error.LengthSquared > Converged; step++)
            {
                double determinant = xx * yy - xy * yx;
                var move = new Vector2D((yy * error.X - xy * error.Y) / determinant, (xx * error.Y - yx * error.X) / determinant);

                // A full step may overshoot where the model bends back; then half of it, and half again.
                double share = 1;
                Vector2D next, nextError;
                do
                {
                    next = ray - move * share;
                    nextError = Distort(next, out xx, out xy, out yx, out yy) - distorted;
                    share /= 2;
                }
                while (!(nextError.LengthSquared < error.LengthSquared) && share > 1e-3);
                if (!(nextError.LengthSquared < error.LengthSquared))
                    break;
                ray = next;
                error = nextError;
            }

            // Rounding alone leaves about 1e-16; an error of 1e-12 is a billionth of a pixel. Where the picture is turned over, the
            // model has left the lens.
            Distort(ray, out xx, out xy, out yx, out yy);
            bool isUpright = xx * yy - xy * yx > 0 && Vector2D.Dot(ray - _center, distorted - _center) >= 0;
            return error.LengthSquared < 1e-24 && isUpright && IsInside(ray);
        }

        /// <summary>
        /// The distorted ray and its derivatives, also where the model no longer holds (a solver may pass through).
        /// </summary>
        /// <param name="ray">Normalised to z = 1.</param>
        /// <param name="byRay">2×2, row by row: d(x', y') by (x, y).</param>
        /// <param name="byCoefficients">2×5 or 2×8, row by row, columns in OpenCV's order; or empty.</param>
        public Vector2D Distort(Vector2D ray, Span<double> byRay, Span<double> byCoefficients)
        {
            Vector2D distorted = Distort(ray, out byRay[0], out byRay[1], out byRay[2], out byRay[3]);
            if (byCoefficients.IsEmpty)
                return distorted;
            double x = ray.X - _center.X, y = ray.Y - _center.Y, r2 = x * x + y * y;
            double above = 1 + r2 * (_k1 + r2 * (_k2 + r2 * _k3)), below = 1 + r2 * (_k4 + r2 * (_k5 + r2 * _k6));
            int columns = byCoefficients.Length / 2;
            for (int row = 0; row < 2; row++)
            {
                Span<double> by = byCoefficients.Slice(row * columns, columns);
                double slope = (row == 0 ? x : y) / below, radial = above / below;
                by[0] = slope * r2;
                by[1] = slope * r2 * r2;
                by[2] = row == 0 ? _cross * x * y : r2 + 2 * y * y;
                by[3] = row == 0 ? r2 + 2 * x * x : _cross * x * y;
                by[4] = slope * r2 * r2 * r2;
                if (columns == 8)
                {
                    by[5] = -radial * by[0];
                    by[6] = -radial * by[1];
                    by[7] = -radial * by[4];
                }
            }

            return distorted;
        }

        private bool IsInside(Vector2D ray) => (ray - _center).LengthSquared <= MaxRadius * MaxRadius;

        /// <summary>The distorted ray and its partial derivatives: dx' = xx dx + xy dy, dy' = yx dx + yy dy.</summary>
        private Vector2D Distort(Vector2D ray, out double xx, out double xy, out double yx, out double yy)
        {
            double x = ray.X - _center.X, y = ray.Y - _center.Y, r2 = x * x + y * y;
            double above = 1 + r2 * (_k1 + r2 * (_k2 + r2 * _k3)), below = 1 + r2 * (_k4 + r2 * (_k5 + r2 * _k6));
            double radial = above / below;
            double slope = (_k1 + r2 * (2 * _k2 + 3 * r2 * _k3) - radial * (_k4 + r2 * (2 * _k5 + 3 * r2 * _k6))) / below;
            xx = radial + 2 * x * x * slope + _cross * _p1 * y + 6 * _p2 * x;
            xy = 2 * x * y * slope + _cross * _p1 * x + 2 * _p2 * y;
            yx = 2 * x * y * slope + 2 * _p1 * x + _cross * _p2 * y;
            yy = radial + 2 * y * y * slope + 6 * _p1 * y + _cross * _p2 * x;
            return new Vector2D(
                x * radial + _cross * _p1 * x * y + _p2 * (r2 + 2 * x * x) + _center.X,
                y * radial + _p1 * (r2 + 2 * y * y) + _cross * _p2 * x * y + _center.Y);
        }
    }
}
