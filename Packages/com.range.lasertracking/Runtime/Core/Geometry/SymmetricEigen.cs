using System;

namespace LaserTracking.Geometry
{
    /// <summary>Eigenvalues and eigenvectors of small symmetric matrices by cyclic Jacobi rotations (Golub and Van Loan, 8.5).</summary>
    public static class SymmetricEigen
    {
        private const int MaximumSweeps = 60;

        /// <summary>Ascending eigenvalues; column k of the vectors belongs to value k. The matrix is left unchanged.</summary>
        public static void Decompose(double[,] symmetric, out double[] values, out double[,] vectors)
        {
            int n = symmetric.GetLength(0);
            var a = (double[,])symmetric.Clone();
            vectors = new double[n, n];
            for (int i = 0; i < n; i++)
                vectors[i, i] = 1;

            for (int sweep = 0; sweep < MaximumSweeps; sweep++)
            {
                double off = 0, diagonal = 0;
                for (int p = 0; p < n; p++)
                {
                    diagonal += a[p, p] * a[p, p];
                    for (int q = p + 1; q < n; q++)
                        off += a[p, q] * a[p, q];
                }

                if (off <= 1e-36 * diagonal)
                    break;
                for (int p = 0; p < n; p++)
                for (int q = p + 1; q < n; q++)
                    Rotate(a, vectors, p, q);
            }

            Sort(a, vectors, out values);
        }

        private static void Rotate(double[,] a, double[,] vectors, int p, int q)
        {
            if (a[p, q] == 0)
                return;
            int n = a.GetLength(0);
            double theta = (a[q, q] - a[p, p]) / (2 * a[p, q]);
            double t = (theta >= 0 ? 1 : -1) / (Math.Abs(theta) + Math.Sqrt(theta * theta + 1));
            double c = 1 / Math.Sqrt(t * t + 1), s = t * c;
            for (int k = 0; k < n; k++)
            {
                double kp = a[k, p], kq = a[k, q];
                a[k, p] = c * kp - s * kq;
                a[k, q] = s * kp + c * kq;
            }

            for (int k = 0; k < n; k++)
            {
                double pk = a[p, k], qk = a[q, k];
                a[p, k] = c * pk - s * qk;
                a[q, k] = s * pk + c * qk;
                double vp = vectors[k, p], vq = vectors[k, q];
                vectors[k, p] = c * vp - s * vq;
                vectors[k, q] = s * vp + c * vq;
            }
        }

        private static void Sort(double[,] a, double[,] vectors, out double[] values)
        {
            int n = a.GetLength(0);
            values = new double[n];
            for (int i = 0; i < n; i++)
                values[i] = a[i, i];
            for (int i = 0; i < n; i++)
            {
                int smallest = i;
                for (int j = i + 1; j < n; j++)
                    smallest = values[j] < values[smallest] ? j : smallest;
                (values[i], values[smallest]) = (values[smallest], values[i]);
                for (int k = 0; k < n; k++)
                    (vectors[k, i], vectors[k, smallest]) = (vectors[k, smallest], vectors[k, i]);
            }
        }
    }
}
