// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    /// <summary>Gauss-Jordan elimination in double with row exchange. Not Unity's: a private helper of the stand-in.</summary>
    internal static class MatrixInverse
    {
        public static Matrix4x4 Of(Matrix4x4 matrix)
        {
            // On the stack: what the components allocate is measured through this.
            System.Span<double> work = stackalloc double[32];
            for (int row = 0; row < 4; row++)
            {
                for (int column = 0; column < 4; column++)
                    work[row * 8 + column] = matrix[row, column];
                work[row * 8 + 4 + row] = 1;
            }

            for (int pivot = 0; pivot < 4; pivot++)
            {
                int best = pivot;
                for (int row = pivot + 1; row < 4; row++)
                {
                    if (System.Math.Abs(work[row * 8 + pivot]) > System.Math.Abs(work[best * 8 + pivot]))
                        best = row;
                }

                if (work[best * 8 + pivot] == 0)
                    return default;
                for (int column = 0; column < 8; column++)
                {
                    double swapped = work[pivot * 8 + column];
                    work[pivot * 8 + column] = work[best * 8 + column];
                    work[best * 8 + column] = swapped;
                }

                double scale = 1 / work[pivot * 8 + pivot];
                for (int column = 0; column < 8; column++)
                    work[pivot * 8 + column] *= scale;
                for (int row = 0; row < 4; row++)
                {
                    double factor = row == pivot ? 0 : work[row * 8 + pivot];
                    for (int column = 0; column < 8; column++)
                        work[row * 8 + column] -= factor * work[pivot * 8 + column];
                }
            }

            var inverse = default(Matrix4x4);
            for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
                inverse[row, column] = (float)work[row * 8 + 4 + column];
            return inverse;
        }
    }
}
