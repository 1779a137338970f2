using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Rotation vectors (axis times angle in radians) to matrices with derivatives, for solvers; <see cref="Rotation3D"/> holds the
    /// rotation itself. R = I + a[v] + b[v]² with a = sin θ / θ, b = (1 − cos θ) / θ² (Rodrigues 1840). Allocates nothing.
    /// </summary>
    public static class Rodrigues
    {
        // Below this angle a series keeps the digits that the closed form loses to cancellation.
        private const double SmallAngle = 0.05;

        /// <summary>The matrix of a rotation vector.</summary>
        /// <param name="vector">Axis times angle, radians, any length.</param>
        /// <param name="matrix">3×3, row by row.</param>
        public static void ToMatrix(Vector3D vector, Span<double> matrix)
        {
            Factors(vector.Length, out double a, out double b, out _, out _);
            double x = vector.X, y = vector.Y, z = vector.Z;
            matrix[0] = 1 - b * (y * y + z * z);
            matrix[1] = b * x * y - a * z;
            matrix[2] = b * x * z + a * y;
            matrix[3] = b * x * y + a * z;
            matrix[4] = 1 - b * (x * x + z * z);
            matrix[5] = b * y * z - a * x;
            matrix[6] = b * x * z - a * y;
            matrix[7] = b * y * z + a * x;
            matrix[8] = 1 - b * (x * x + y * y);
        }

        /// <summary>The matrix and its derivatives.</summary>
        /// <param name="vector">Axis times angle, radians, any length.</param>
        /// <param name="matrix">3×3, row by row.</param>
        /// <param name="byVector">9×3: element i of the matrix by component k of the vector stands at 3 i + k.</param>
        public static void ToMatrix(Vector3D vector, Span<double> matrix, Span<double> byVector)
        {
            ToMatrix(vector, matrix);
            Factors(vector.Length, out double a, out double b, out double aSlope, out double bSlope);
            Span<double> v = stackalloc double[] { vector.X, vector.Y, vector.Z };
            double squared = vector.LengthSquared;
            for (int row = 0; row < 3; row++)
            for (int column = 0; column < 3; column++)
            for (int k = 0; k < 3; k++)
            {
                // [v]: element (row, column) is ± the third component; [v]² = v vᵀ − θ² I.
                int third = 3 - row - column;
                double sign = (column - row + 3) % 3 == 1 ? -1 : 1;
                double cross = row == column ? 0 : sign * v[third], crossSlope = row != column && third == k ? sign : 0;
                double square = v[row] * v[column] - (row == column ? squared : 0);
                double squareSlope = (row == k ? v[column] : 0) + (column == k ? v[row] : 0) - (row == column ? 2 * v[k] : 0);
                byVector[(row * 3 + column) * 3 + k] = aSlope * v[k] * cross + a * crossSlope + bSlope * v[k] * square + b * squareSlope;
            }
        }

        /// <summary>a and b, and their derivatives by the angle divided by it.</summary>
        private static void Factors(double angle, out double a, out double b, out double aSlope, out double bSlope)
        {
            double t = angle * angle;
            if (angle < SmallAngle)
            {
                a = 1 - t / 6 * (1 - t / 20 * (1 - t / 42 * (1 - t / 72)));
                b = 0.5 - t / 24 * (1 - t / 30 * (1 - t / 56 * (1 - t / 90)));
                aSlope = -1.0 / 3 + t / 30 * (1 - t / 28 * (1 - t / 54));
                bSlope = -1.0 / 12 + t / 180 * (1 - t * 3 / 112 * (1 - t * 2 / 135));
                return;
            }

            double half = Math.Sin(angle / 2) / angle;
            a = Math.Sin(angle) / angle;
            b = 2 * half * half;
            aSlope = (Math.Cos(angle) - a) / t;
            bSlope = (a - 2 * b) / t;
        }
    }
}
