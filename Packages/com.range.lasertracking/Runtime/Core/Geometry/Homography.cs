using System;

namespace LaserTracking.Geometry
{
    /// <summary>A projective mapping of the plane: a 3×3 matrix up to scale, scaled so that its last element is 1 where possible.</summary>
    public readonly struct Homography
    {
        private readonly double _a, _b, _c, _d, _e, _f, _g, _h, _i;

        /// <param name="rowMajor">Nine finite numbers.</param>
        /// <exception cref="ArgumentException">Not nine numbers, not finite, or the matrix has no inverse.</exception>
        public Homography(ReadOnlySpan<double> rowMajor)
        {
            if (rowMajor.Length != 9)
                throw new ArgumentException("a homography has nine elements");
            double largest = 0;
            foreach (double value in rowMajor)
            {
                if (double.IsNaN(value) || double.IsInfinity(value))
                    throw new ArgumentException("a homography's elements must be finite");
                largest = Math.Max(largest, Math.Abs(value));
            }

            double scale = Math.Abs(rowMajor[8]) > 1e-12 * largest ? rowMajor[8] : largest;
            if (!(largest > 0))
                throw new ArgumentException("a homography of zeros has no inverse");
            _a = rowMajor[0] / scale;
            _b = rowMajor[1] / scale;
            _c = rowMajor[2] / scale;
            _d = rowMajor[3] / scale;
            _e = rowMajor[4] / scale;
            _f = rowMajor[5] / scale;
            _g = rowMajor[6] / scale;
            _h = rowMajor[7] / scale;
            _i = rowMajor[8] / scale;
        }

        public static Homography Identity => new Homography(new double[] { 1, 0, 0, 0, 1, 0, 0, 0, 1 });

        public double Determinant => _a * (_e * _i - _f * _h) - _b * (_d * _i - _f * _g) + _c * (_d * _h - _e * _g);

        public Homography Inverse => new Homography(new[]
        {
            _e * _i - _f * _h, _c * _h - _b * _i, _b * _f - _c * _e,
            _f * _g - _d * _i, _a * _i - _c * _g, _c * _d - _a * _f,
            _d * _h - _e * _g, _b * _g - _a * _h, _a * _e - _b * _d,
        });

        /// <summary>first, then this: (this ∘ first).</summary>
        public static Homography operator *(Homography second, Homography first)
        {
            double[] p = second.ToArray(), q = first.ToArray(), r = new double[9];
            for (int row = 0; row < 3; row++)
            for (int column = 0; column < 3; column++)
                r[row * 3 + column] = p[row * 3] * q[column] + p[row * 3 + 1] * q[3 + column] + p[row * 3 + 2] * q[6 + column];
            return new Homography(r);
        }

        /// <summary>The image of a point; infinite for a point on the horizon.</summary>
        public Vector2D Map(Vector2D p)
        {
            double w = _g * p.X + _h * p.Y + _i;
            return new Vector2D((_a * p.X + _b * p.Y + _c) / w, (_d * p.X + _e * p.Y + _f) / w);
        }

        /// <summary>Partial derivatives at a point: dx' = xx dx + xy dy, dy' = yx dx + yy dy.</summary>
        public void Jacobian(Vector2D p, out double xx, out double xy, out double yx, out double yy)
        {
            double w = _g * p.X + _h * p.Y + _i;
            Vector2D image = Map(p);
            xx = (_a - image.X * _g) / w;
            xy = (_b - image.X * _h) / w;
            yx = (_d - image.Y * _g) / w;
            yy = (_e - image.Y * _h) / w;
        }

        /// <summary>Nine elements, row by row.</summary>
        public double[] ToArray() => new[] { _a, _b, _c, _d, _e, _f, _g, _h, _i };
    }
}
