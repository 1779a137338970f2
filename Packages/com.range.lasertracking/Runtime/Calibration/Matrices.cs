using System;
using LaserTracking.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace LaserTracking.Calibration
{
    /// <summary>3×3 matrices between Core's types, plain rows of nine numbers and MathNet.</summary>
    internal static class Matrices
    {
        /// <summary>Row by row.</summary>
        public static Matrix<double> Of(double[] rows) => Matrix<double>.Build.Dense(3, 3, (row, column) => rows[row * 3 + column]);

        public static Matrix<double> Of(Rotation3D rotation) => Of(rotation.ToMatrix());

        /// <summary>[v]: [v] w = v × w.</summary>
        public static Matrix<double> Cross(Vector3D v) => Of(new[] { 0, -v.Z, v.Y, v.Z, 0, -v.X, -v.Y, v.X, 0 });

        public static Matrix<double> OfPinhole(PinholeCamera camera) => Of(new[] { camera.FocalXPx, 0, camera.CenterXPx, 0, camera.FocalYPx, camera.CenterYPx, 0, 0, 1 });

        /// <summary>Nine numbers, row by row.</summary>
        public static double[] Rows(Matrix<double> matrix) => matrix.ToRowMajorArray();

        public static Vector3D Apply(Matrix<double> m, Vector3D v) => new Vector3D(
            m[0, 0] * v.X + m[0, 1] * v.Y + m[0, 2] * v.Z, m[1, 0] * v.X + m[1, 1] * v.Y + m[1, 2] * v.Z, m[2, 0] * v.X + m[2, 1] * v.Y + m[2, 2] * v.Z);

        /// <summary>The rotation nearest to nine numbers, row by row, that are nearly one (Arun et al. 1987).</summary>
        public static Rotation3D NearestRotation(double[] rows)
        {
            var svd = Of(rows).Svd();
            Matrix<double> rotation = svd.U * svd.VT;
            if (rotation.Determinant() < 0)
                rotation = svd.U * Matrix<double>.Build.DenseOfDiagonalArray(new double[] { 1, 1, -1 }) * svd.VT;
            return Rotation3D.TryFromMatrix(Rows(rotation), out Rotation3D result) ? result : throw new ArgumentException("the numbers are no rotation");
        }
    }
}
