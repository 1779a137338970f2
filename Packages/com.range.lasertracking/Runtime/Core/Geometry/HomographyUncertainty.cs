using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// How far a fitted homography may be off, anywhere: the covariance of the points that it maps to, linearised. Held as the
    /// covariance of its eight parameters on normalised points, jointly with that of the lens where the same points gave it.
    /// Immutable; asking for a point allocates nothing.
    /// </summary>
    public sealed class HomographyUncertainty
    {
        private const int Parameters = 8;
        private readonly PointNormalization _from;
        private readonly double _toScale;
        private readonly double[] _h;
        private readonly double[,] _covariance;

        /// <param name="from">Of the points that are mapped.</param>
        /// <param name="toScale">Scale of the points that are mapped to.</param>
        /// <param name="normalized">The homography between normalised points, nine elements, the last one 1.</param>
        /// <param name="covariance">8×8, of the others of these; larger: jointly with as many coefficients of the lens after them.</param>
        internal HomographyUncertainty(PointNormalization from, double toScale, double[] normalized, double[,] covariance)
        {
            LensCoefficients = covariance.GetLength(0) - Parameters;
            _from = from;
            _toScale = toScale;
            _h = normalized;
            _covariance = covariance;
        }

        /// <summary>Radial coefficients k1, k2 of the lens that were found together with the homography: 0 when it was given, else 2.</summary>
        public int LensCoefficients { get; }

        /// <summary>From the joint covariance of where four points are mapped to: that says all there is to say about a homography.</summary>
        /// <param name="homography">The mapping.</param>
        /// <param name="anchors">Four points that are mapped, no three on a line.</param>
        /// <param name="covariance">8×8, of x₀, y₀, x₁, y₁, …, or 10×10, with k1, k2 after them; symmetric, no negative eigenvalue.</param>
        /// <param name="uncertainty">Valid only when true is returned.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryFromAnchors(Homography homography, ReadOnlySpan<Vector2D> anchors, double[,] covariance, out HomographyUncertainty? uncertainty, out string reason)
        {
            uncertainty = null;
            int size = covariance.GetLength(0), coefficients = size - Parameters;
            if (anchors.Length != 4 || (coefficients != 0 && coefficients != PlaneLens.Coefficients) || covariance.GetLength(1) != size)
                reason = "a homography's covariance is that of four points, 8×8, or with two coefficients of the lens 10×10";
            else if (!IsCovariance(covariance))
                reason = "this is no covariance: it must be finite and symmetric without negative eigenvalues";
            else
                reason = string.Empty;
            if (reason.Length > 0)
                return false;

            var images = new Vector2D[4];
            for (int i = 0; i < 4; i++)
                images[i] = homography.Map(anchors[i]);
            PointNormalization from = PointNormalization.Of(anchors), to = PointNormalization.Of(images);
            double[] h = (to.Matrix * homography * from.Matrix.Inverse).ToArray();
            var bare = new HomographyUncertainty(from, to.Scale, h, new double[Parameters, Parameters]);

            // Parameters = J⁻¹ × anchors; the square J is inverted by way of JᵀJ, harmless at the condition of normalised points.
            double[,] j = bare.Derivatives(anchors), normal = Multiply(Transpose(j), j);
            if (!Cholesky.TryFactor(normal))
            {
                reason = "the four points do not fix the mapping: three of them lie on one line";
                return false;
            }

            double[,] inverse = Widened(Multiply(Cholesky.Inverse(normal), Transpose(j)), coefficients);
            uncertainty = new HomographyUncertainty(from, to.Scale, h, Multiply(Multiply(inverse, covariance), Transpose(inverse)));
            return true;
        }

        /// <summary>Covariance of the point that this one is mapped to, in the square of its unit.</summary>
        /// <param name="from">The point that is mapped.</param>
        /// <param name="byLens">How the distance from a pixel's own point grows with the coefficients: 2×n, row by row. Empty: that of the mapping alone.</param>
        public Covariance2D At(Vector2D from, ReadOnlySpan<double> byLens = default)
        {
            int count = Parameters + byLens.Length / 2;
            Span<double> x = stackalloc double[Parameters + PlaneLens.Coefficients], y = stackalloc double[Parameters + PlaneLens.Coefficients];
            Derive(from, x, y);
            for (int i = Parameters; i < count; i++)
            {
                x[i] = byLens[i - Parameters];
                y[i] = byLens[count - 2 * Parameters + i];
            }

            double xx = 0, xy = 0, yy = 0;
            for (int i = 0; i < count; i++)
            for (int k = 0; k < count; k++)
            {
                double c = _covariance[i, k];
                xx += x[i] * c * x[k];
                xy += x[i] * c * y[k];
                yy += y[i] * c * y[k];
            }

            return new Covariance2D(xx, xy, yy);
        }

        /// <summary>Joint covariance of the points that these are mapped to, of x₀, y₀, x₁, y₁, …, and of the lens's coefficients, if any, after them.</summary>
        public double[,] Of(ReadOnlySpan<Vector2D> from)
        {
            double[,] j = Widened(Derivatives(from), LensCoefficients);
            return Multiply(Multiply(j, _covariance), Transpose(j));
        }

        private double[,] Derivatives(ReadOnlySpan<Vector2D> from)
        {
            var result = new double[2 * from.Length, Parameters];
            Span<double> x = stackalloc double[Parameters], y = stackalloc double[Parameters];
            for (int i = 0; i < from.Length; i++)
            {
                Derive(from[i], x, y);
                for (int k = 0; k < Parameters; k++)
                {
                    result[2 * i, k] = x[k];
                    result[2 * i + 1, k] = y[k];
                }
            }

            return result;
        }

        private void Derive(Vector2D from, Span<double> x, Span<double> y)
        {
            Derive(_h, _from.Apply(from), x, y);
            for (int k = 0; k < Parameters; k++)
            {
                x[k] /= _toScale;
                y[k] /= _toScale;
            }
        }

        /// <summary>The image of a point under eight parameters (the ninth is 1) and its derivatives by them.</summary>
        internal static Vector2D Derive(ReadOnlySpan<double> h, Vector2D p, Span<double> x, Span<double> y)
        {
            double w = 1 / (h[6] * p.X + h[7] * p.Y + 1);
            var image = new Vector2D((h[0] * p.X + h[1] * p.Y + h[2]) * w, (h[3] * p.X + h[4] * p.Y + h[5]) * w);
            x.Clear();
            y.Clear();
            x[0] = y[3] = p.X * w;
            x[1] = y[4] = p.Y * w;
            x[2] = y[5] = w;
            x[6] = -image.X * p.X * w;
            x[7] = -image.X * p.Y * w;
            y[6] = -image.Y * p.X * w;
            y[7] = -image.Y * p.Y * w;
            return image;
        }

        private static bool IsCovariance(double[,] c)
        {
            double largest = 0;
            foreach (double value in c)
            {
                if (double.IsNaN(value) || double.IsInfinity(value))
                    return false;
                largest = Math.Max(largest, Math.Abs(value));
            }

            for (int i = 0; i < c.GetLength(0); i++)
            for (int k = 0; k < i; k++)
            {
                if (Math.Abs(c[i, k] - c[k, i]) > 1e-6 * largest)
                    return false;
            }

            SymmetricEigen.Decompose(c, out double[] values, out _);
            return values[0] >= -1e-6 * largest;
        }

        /// <summary>With so many rows and columns more, in which what comes in goes out.</summary>
        private static double[,] Widened(double[,] a, int more)
        {
            int rows = a.GetLength(0), columns = a.GetLength(1);
            var result = new double[rows + more, columns + more];
            for (int i = 0; i < rows; i++)
            for (int k = 0; k < columns; k++)
                result[i, k] = a[i, k];
            for (int i = 0; i < more; i++)
                result[rows + i, columns + i] = 1;
            return result;
        }

        private static double[,] Multiply(double[,] a, double[,] b)
        {
            var result = new double[a.GetLength(0), b.GetLength(1)];
            for (int i = 0; i < result.GetLength(0); i++)
            for (int k = 0; k < b.GetLength(0); k++)
            for (int j = 0; j < result.GetLength(1); j++)
                result[i, j] += a[i, k] * b[k, j];
            return result;
        }

        private static double[,] Transpose(double[,] a)
        {
            var result = new double[a.GetLength(1), a.GetLength(0)];
            for (int i = 0; i < result.GetLength(0); i++)
            for (int j = 0; j < result.GetLength(1); j++)
                result[i, j] = a[j, i];
            return result;
        }
    }
}
