using System;

namespace LaserTracking.Geometry
{
    /// <summary>Small symmetric positive definite systems by Cholesky's factorisation (Golub and Van Loan, 4.2). Square matrices, row and column; any thread.</summary>
    public static class Cholesky
    {
        /// <summary>Turns the lower half into L with L Lᵀ = A; false when A is not positive definite (to within rounding).</summary>
        public static bool TryFactor(double[,] a)
        {
            int n = a.GetLength(0);
            for (int j = 0; j < n; j++)
            {
                double diagonal = a[j, j], sum = diagonal;
                for (int k = 0; k < j; k++)
                    sum -= a[j, k] * a[j, k];
                if (!(sum > 1e-14 * Math.Abs(diagonal)) || double.IsInfinity(sum))
                    return false;
                a[j, j] = Math.Sqrt(sum);
                for (int i = j + 1; i < n; i++)
                {
                    double value = a[i, j];
                    for (int k = 0; k < j; k++)
                        value -= a[i, k] * a[j, k];
                    a[i, j] = value / a[j, j];
                }
            }

            return true;
        }

        /// <summary>Replaces b by the solution x of L Lᵀ x = b.</summary>
        public static void Solve(double[,] factor, double[] b)
        {
            int n = b.Length;
            for (int i = 0; i < n; i++)
            {
                for (int k = 0; k < i; k++)
                    b[i] -= factor[i, k] * b[k];
                b[i] /= factor[i, i];
            }

            for (int i = n - 1; i >= 0; i--)
            {
                for (int k = i + 1; k < n; k++)
                    b[i] -= factor[k, i] * b[k];
                b[i] /= factor[i, i];
            }
        }

        /// <summary>(L Lᵀ)⁻¹.</summary>
        public static double[,] Inverse(double[,] factor)
        {
            int n = factor.GetLength(0);
            var inverse = new double[n, n];
            var column = new double[n];
            for (int j = 0; j < n; j++)
            {
                Array.Clear(column, 0, n);
                column[j] = 1;
                Solve(factor, column);
                for (int i = 0; i < n; i++)
                    inverse[i, j] = column[i];
            }

            return inverse;
        }
    }
}
