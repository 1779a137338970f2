using System;
using System.Runtime.CompilerServices;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Brightness around a place where two edges cross: plane + amplitude · erf(distance to edge 1 / √2σ) · erf(distance to edge 2 / √2σ).
    /// Parameters: crossing x and y (from the window's centre), angles of the edges, blur σ, mean, amplitude, slopes along x and y.
    /// </summary>
    internal readonly unsafe struct CrossingModel
    {
        public const int Parameters = 9;

        public const int Blur = 4;

        private const double LeastContrast = 1;

        private readonly double _x, _y, _cosA, _sinA, _cosB, _sinB, _mean, _amplitude, _slopeX, _slopeY, _inverseBlur;

        public CrossingModel(double* p)
        {
            _x = p[0];
            _y = p[1];
            _cosA = Math.Cos(p[2]);
            _sinA = Math.Sin(p[2]);
            _cosB = Math.Cos(p[3]);
            _sinB = Math.Sin(p[3]);
            _inverseBlur = 1 / p[Blur];
            _mean = p[5];
            _amplitude = p[6];
            _slopeX = p[7];
            _slopeY = p[8];
        }

        /// <summary>Parameters to begin with. Behind edge A, and before edge B, it is dark: the product of the distances is negative there.</summary>
        public static void Start(double* p, in SaddlePoint point, double mean)
        {
            p[0] = p[1] = p[7] = p[8] = 0;
            p[2] = Math.Atan2(point.EdgeA.Y, point.EdgeA.X);
            p[3] = Math.Atan2(point.EdgeB.Y, point.EdgeB.X);
            p[Blur] = 1.2;
            p[5] = mean;
            p[6] = point.Contrast / 2;
        }

        /// <summary>The fitted point; false when light and dark have changed places, the edges fell together or no contrast is left.</summary>
        public static bool TryRead(double* p, in SaddlePoint start, double quality, out SaddlePoint point)
        {
            var a = new Vector2D(Math.Cos(p[2]), Math.Sin(p[2]));
            var b = new Vector2D(Math.Cos(p[3]), Math.Sin(p[3]));
            point = new SaddlePoint(start.PositionPx + new Vector2D(p[0], p[1]), a, b, 2 * p[6], quality);
            return point.Contrast > LeastContrast && Vector2D.Cross(a, b) > 0.1 && point.PositionPx.IsFinite;
        }

        /// <summary>Brightness at a place, and its derivatives by the nine parameters.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public double Evaluate(double dx, double dy, double* derivatives)
        {
            double x = dx - _x, y = dy - _y;
            double distanceA = (_cosA * y - _sinA * x) * _inverseBlur, distanceB = (_cosB * y - _sinB * x) * _inverseBlur;
            double a = Erf(distanceA, out double bellA), b = Erf(distanceB, out double bellB);
            double byA = _amplitude * b * bellA * _inverseBlur, byB = _amplitude * a * bellB * _inverseBlur;
            derivatives[0] = byA * _sinA + byB * _sinB;
            derivatives[1] = -byA * _cosA - byB * _cosB;
            derivatives[2] = -byA * (_cosA * x + _sinA * y);
            derivatives[3] = -byB * (_cosB * x + _sinB * y);
            derivatives[Blur] = -byA * distanceA - byB * distanceB;
            derivatives[5] = 1;
            derivatives[6] = a * b;
            derivatives[7] = dx;
            derivatives[8] = dy;
            return _mean + _slopeX * dx + _slopeY * dy + _amplitude * a * b;
        }

        /// <summary>Solves the symmetric equations (lower triangle, overwritten) by Cholesky's method; false when they are singular.</summary>
        public static bool TrySolve(double* matrix, double* right, double* solution)
        {
            for (int i = 0; i < Parameters; i++)
            {
                double* row = matrix + i * Parameters;
                for (int j = 0; j <= i; j++)
                {
                    double sum = row[j];
                    double* other = matrix + j * Parameters;
                    for (int k = 0; k < j; k++)
                        sum -= row[k] * other[k];
                    if (j < i)
                        row[j] = sum / other[j];
                    else if (sum > 0)
                        row[j] = Math.Sqrt(sum);
                    else
                        return false;
                }
            }

            for (int i = 0; i < Parameters; i++)
            {
                double sum = right[i];
                for (int k = 0; k < i; k++)
                    sum -= matrix[i * Parameters + k] * solution[k];
                solution[i] = sum / matrix[i * Parameters + i];
            }

            for (int i = Parameters - 1; i >= 0; i--)
            {
                double sum = solution[i];
                for (int k = i + 1; k < Parameters; k++)
                    sum -= matrix[k * Parameters + i] * solution[k];
                solution[i] = sum / matrix[i * Parameters + i];
            }

            return true;
        }

        /// <summary>
        /// erf(z / √2) by Abramowitz and Stegun's 7.1.26 (1.5e-7 off at most) and its derivative, which share the exponential.
        /// </summary>
        private static double Erf(double z, out double derivative)
        {
            double u = Math.Abs(z) * 0.70710678118654752;
            double bell = Math.Exp(-u * u);
            double t = 1 / (1 + 0.3275911 * u);
            double tail = ((((1.061405429 * t - 1.453152027) * t + 1.421413741) * t - 0.284496736) * t + 0.254829592) * t * bell;
            derivative = 0.79788456080286536 * bell;
            return z < 0 ? tail - 1 : 1 - tail;
        }
    }
}
