using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Lens distortion after Brown (1966) and Conrady (1919), radial part rational with eight coefficients in all (Claus and Fitzgibbon
    /// 2005); with k4 = k5 = k6 = 0 the usual five. Works on rays normalised to z = 1. Inverted exactly by Newton's method: the usual
    /// few steps of fixed-point iteration are off by pixels with strong lenses. Immutable, allocates nothing.
    /// </summary>
    public sealed class BrownDistortion
    {
        private const int MaxSteps = 40;
        private const double Converged = 1e-24;
        private readonly double _k1, _k2, _k3, _k4, _k5, _k6, _p1, _p2;

        /// <param name="k">Radial: k1 to k3 of the numerator and k4 to k6 of the denominator; three or six finite numbers.</param>
        /// <param name="p1">Tangential.</param>
        /// <param name="p2">Tangential.</param>
        /// <param name="maxRadius">Largest undistorted radius at which the model holds, above zero; infinity when not known.</param>
        /// <exception cref="ArgumentException">Another count of coefficients, or one that is not finite.</exception>
        public BrownDistortion(ReadOnlySpan<double> k, double p1, double p2, double maxRadius = double.PositiveInfinity)
        {
            if (k.Length != 3 && k.Length != 6)
                throw new ArgumentException("a lens has three or six radial coefficients");
            double sum = p1 + p2;
            foreach (double value in k)
                sum += value;
            if (double.IsNaN(sum) || double.IsInfinity(sum))
                throw new ArgumentException("a lens's coefficients must be finite");
            if (!(maxRadius > 0))
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
            MaxRadius = maxRadius;
        }

        /// <summary>Largest undistorted radius at which the model holds.</summary>
        public double MaxRadius { get; }

        /// <summary>Where the lens puts a ray; false beyond the radius up to which the model holds.</summary>
        public bool TryDistort(Vector2D ray, out Vector2D distorted)
        {
            distorted = Distort(ray, out _, out _, out _, out _);
            return ray.LengthSquared <= MaxRadius * MaxRadius && distorted.IsFinite;
        }

        /// <summary>The ray that the lens put here; false where there is none or the search does not settle.</summary>
        public bool TryUndistort(Vector2D distorted, out Vector2D ray)
        {
            ray = distorted;
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

            // Rounding alone leaves about 1e-15; an error of 1e-9 is a millionth of a pixel. Where the picture is turned over, the
            // model has left the lens.
            bool isUpright = xx * yy - xy * yx > 0 && Vector2D.Dot(ray, distorted) >= 0;
            return error.LengthSquared < 1e-18 && isUpright && ray.LengthSquared <= MaxRadius * MaxRadius;
        }

        /// <summary>The distorted ray and its partial derivatives: dx' = xx dx + xy dy, dy' = yx dx + yy dy.</summary>
        private Vector2D Distort(Vector2D ray, out double xx, out double xy, out double yx, out double yy)
        {
            double x = ray.X, y = ray.Y, r2 = x * x + y * y;
            double above = 1 + r2 * (_k1 + r2 * (_k2 + r2 * _k3)), below = 1 + r2 * (_k4 + r2 * (_k5 + r2 * _k6));
            double radial = above / below;
            double slope = (_k1 + r2 * (2 * _k2 + 3 * r2 * _k3) - radial * (_k4 + r2 * (2 * _k5 + 3 * r2 * _k6))) / below;
            xx = radial + 2 * x * x * slope + 2 * _p1 * y + 6 * _p2 * x;
            xy = 2 * x * y * slope + 2 * _p1 * x + 2 * _p2 * y;
            yx = xy;
            yy = radial + 2 * y * y * slope + 6 * _p1 * y + 2 * _p2 * x;
            return new Vector2D(
                x * radial + 2 * _p1 * x * y + _p2 * (r2 + 2 * x * x),
                y * radial + _p1 * (r2 + 2 * y * y) + 2 * _p2 * x * y);
        }
    }
}
