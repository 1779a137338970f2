using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace LaserTracking.Calibration
{
    /// <summary>What two views of one point say about each other: right' F left = 0 in undistorted pixels, right' E left = 0 for rays.</summary>
    public sealed class EpipolarGeometry
    {
        private readonly StereoRig _rig;
        private readonly Matrix<double> _fundamental;

        public EpipolarGeometry(StereoRig rig)
        {
            _rig = rig;
            Matrix<double> essential = Matrices.Cross(rig.LeftToRight.Position) * Matrices.Of(rig.LeftToRight.Rotation);
            _fundamental = Matrices.OfPinhole(rig.Right.Pinhole).Inverse().Transpose() * essential * Matrices.OfPinhole(rig.Left.Pinhole).Inverse();
            if (Math.Abs(_fundamental[2, 2]) > 1e-12 * _fundamental.FrobeniusNorm())
                _fundamental /= _fundamental[2, 2];
            Essential = Matrices.Rows(essential);
            Fundamental = Matrices.Rows(_fundamental);
        }

        /// <summary>E = [T] R, nine numbers row by row.</summary>
        public double[] Essential { get; }

        /// <summary>F, its last element 1 where possible, nine numbers row by row.</summary>
        public double[] Fundamental { get; }

        /// <summary>Distances of undistorted pixels from the epipolar line of their partner, left and right; false outside a lens model.</summary>
        public bool TryDistances(Vector2D leftPx, Vector2D rightPx, out double left, out double right)
        {
            left = right = 0;
            if (!_rig.Left.TryUnproject(leftPx, out Vector2D leftRay) || !_rig.Right.TryUnproject(rightPx, out Vector2D rightRay))
                return false;
            Vector3D p = Undistorted(_rig.Left.Pinhole, leftRay), q = Undistorted(_rig.Right.Pinhole, rightRay);
            Vector3D inRight = Matrices.Apply(_fundamental, p), inLeft = Matrices.Apply(_fundamental.Transpose(), q);
            double product = Math.Abs(Vector3D.Dot(q, inRight));
            left = product / Math.Sqrt(inLeft.X * inLeft.X + inLeft.Y * inLeft.Y);
            right = product / Math.Sqrt(inRight.X * inRight.X + inRight.Y * inRight.Y);
            return true;
        }

        /// <summary>Over many point pairs: the mean of left and right distance added, and the root mean square of the single distances, px.</summary>
        public (double MeanSumPx, double RmsPx) Errors(IEnumerable<(Vector2D LeftPx, Vector2D RightPx)> points)
        {
            double sum = 0, squares = 0;
            int count = 0;
            foreach ((Vector2D leftPx, Vector2D rightPx) in points)
            {
                if (!TryDistances(leftPx, rightPx, out double left, out double right))
                    continue;
                sum += left + right;
                squares += left * left + right * right;
                count++;
            }

            return count == 0 ? (0, 0) : (sum / count, Math.Sqrt(squares / (2 * count)));
        }

        private static Vector3D Undistorted(PinholeCamera camera, Vector2D ray) =>
            new Vector3D(ray.X * camera.FocalXPx + camera.CenterXPx, ray.Y * camera.FocalYPx + camera.CenterYPx, 1);
    }
}
