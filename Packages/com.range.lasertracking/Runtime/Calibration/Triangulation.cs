using LaserTracking.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace LaserTracking.Calibration
{
    /// <summary>Points in space from two views, by the linear method on rays (Hartley and Zisserman 2004, section 12.2).</summary>
    public static class Triangulation
    {
        /// <summary>The point in camera 0's space that is seen along both rays; false when the rays are parallel.</summary>
        /// <param name="leftRay">Normalised to z = 1.</param>
        /// <param name="rightRay">Normalised to z = 1, in camera 1's space.</param>
        /// <param name="leftToRight">X_right = R X_left + T.</param>
        /// <param name="left">In the unit of T. A depth (z) below zero says that the rays meet behind the camera.</param>
        public static bool TryTriangulate(Vector2D leftRay, Vector2D rightRay, Pose leftToRight, out Vector3D left)
        {
            Matrix<double> r = Matrices.Of(leftToRight.Rotation);
            double[] t = { leftToRight.Position.X, leftToRight.Position.Y, leftToRight.Position.Z };
            var equations = Matrix<double>.Build.Dense(4, 4);
            equations.SetRow(0, new[] { -1, 0, leftRay.X, 0 });
            equations.SetRow(1, new[] { 0, -1, leftRay.Y, 0 });
            for (int column = 0; column < 4; column++)
            {
                double x = column < 3 ? r[0, column] : t[0], y = column < 3 ? r[1, column] : t[1], z = column < 3 ? r[2, column] : t[2];
                equations[2, column] = rightRay.X * z - x;
                equations[3, column] = rightRay.Y * z - y;
            }

            Vector<double> solution = equations.Svd().VT.Row(3);
            left = new Vector3D(solution[0], solution[1], solution[2]) * (1 / solution[3]);
            return left.IsFinite;
        }

        /// <summary>The same from pixels; false also where a pixel lies outside what the lens model covers.</summary>
        public static bool TryTriangulate(StereoRig rig, Vector2D leftPx, Vector2D rightPx, out Vector3D left)
        {
            left = default;
            return rig.Left.TryUnproject(leftPx, out Vector2D leftRay) && rig.Right.TryUnproject(rightPx, out Vector2D rightRay)
                && TryTriangulate(leftRay, rightRay, rig.LeftToRight, out left);
        }
    }
}
