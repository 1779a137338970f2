// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    /// <summary>Gauss-Jordan elimination in double with row exchange. Not Unity's: a private helper of the stand-in.</summary>
    internal static class MatrixInverse
    {
        public static Matrix4x4 Of(Matrix4x4 matrix)
        {
            var work = new double[4, 8];
            for (int row = 0; row < 4; row++)
            {
                for (int column = 0; column < 4; column++)
                    work[row, column] = matrix[row, column];
                work[row, 4 + row] = 1;
            }

            for (int pivot = 0; pivot < 4; pivot++)
            {
                int best = pivot;
                for (int row = pivot + 1; row < 4; row++)
                {
                    if (System.Math.Abs(work[row, pivot]) > System.Math.Abs(work[best, pivot]))
                        best = row;
                }

                if (work[best, pivot] == 0)
                    return default;
                for (int column = 0; column < 8; column++)
                {
                    double swapped = work[pivot, column];
                    work[pivot, column] = work[best, column];
                    work[best, column] = swapped;
                }

                double scale = 1 / work[pivot, pivot];
                for (int column = 0; column < 8; column++)
                    work[pivot, column] *= scale;
                for (int row = 0; row < 4; row++)
                {
                    double factor = row == pivot ? 0 : work[row, pivot];
                    for (int column = 0; column < 8; column++)
                        work[row, column] -= factor * work[pivot, column];
                }
            }

            var inverse = default(Matrix4x4);
            for (int row = 0; row < 4; row++)
            for (int column = 0; column < 4; column++)
                inverse[row, column] = (float)work[row, 4 + column];
            return inverse;
        }
    }
}
