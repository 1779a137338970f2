using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// A first guess of the focal lengths: Zhang's closed form (2000) with the principal point held at the middle of the picture and
    /// without lens. The two axes of a board are at right angles and of equal scale, which is linear in 1/fx² and 1/fy².
    /// </summary>
    internal static class InitialFocalLengths
    {
        // Outside these the guess is no camera's; half a picture's width to twenty of them.
        private const double Least = 0.3;
        private const double Most = 20;

        /// <summary>Parameters of a camera without lens distortion.</summary>
        public static double[] Guess(IReadOnlyList<BoardView> views, int width, int height)
        {
            double centerX = (width - 1) / 2.0, centerY = (height - 1) / 2.0;
            var equations = new List<double[]>();
            foreach (BoardView view in views)
            {
                var centred = new Vector2D[view.ImagePx.Length];
                for (int i = 0; i < centred.Length; i++)
                    centred[i] = (view.ImagePx[i] - new Vector2D(centerX, centerY)) * (1.0 / width);
                if (!HomographyEstimator.TryFit(view.BoardMm, centred, out Homography homography, out _))
                    continue;
                double[] h = homography.ToArray();
                var x = new Vector3D(h[0], h[3], h[6]);
                var y = new Vector3D(h[1], h[4], h[7]);
                Add(equations, x, y);
                Add(equations, x + y, x - y);
            }

            (double inverseX, double inverseY) = Solve(equations);
            double usual = width;
            double focalX = inverseX > 0 ? width / Math.Sqrt(inverseX) : inverseY > 0 ? width / Math.Sqrt(inverseY) : usual;
            double focalY = inverseY > 0 ? width / Math.Sqrt(inverseY) : focalX;
            if (!(Math.Min(focalX, focalY) > Least * width && Math.Max(focalX, focalY) < Most * width))
                focalX = focalY = usual;
            var parameters = new double[CameraParameters.Count];
            parameters[0] = focalX;
            parameters[1] = focalY;
            parameters[2] = centerX;
            parameters[3] = centerY;
            return parameters;
        }

        /// <summary>Two directions of the board at right angles: a.X b.X / fx² + a.Y b.Y / fy² = −a.Z b.Z.</summary>
        private static void Add(List<double[]> equations, Vector3D a, Vector3D b)
        {
            double weight = 1 / (a.Length * b.Length);
            equations.Add(new[] { a.X * b.X * weight, a.Y * b.Y * weight, -a.Z * b.Z * weight });
        }

        private static (double InverseX, double InverseY) Solve(List<double[]> equations)
        {
            if (equations.Count < 2)
                return (0, 0);
            Matrix<double> left = Matrix<double>.Build.Dense(equations.Count, 2, (row, column) => equations[row][column]);
            Vector<double> right = Vector<double>.Build.Dense(equations.Count, row => equations[row][2]);
            Vector<double> solution = left.Svd().Solve(right);
            return (solution[0], solution[1]);
        }
    }
}
