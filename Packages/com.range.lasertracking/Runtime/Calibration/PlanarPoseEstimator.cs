using System;
using LaserTracking.Geometry;
using MathNet.Numerics.LinearAlgebra;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// The pose of a flat board from one view (planar PnP): both closed-form solutions of Collins and Bartoli (2014, "IPPE"), then
    /// Levenberg-Marquardt on the reprojection error from each.
    /// </summary>
    public static class PlanarPoseEstimator
    {
        private const double AmbiguousRatio = 2;

        /// <param name="view">At least four points.</param>
        /// <param name="camera">With its lens.</param>
        /// <param name="pose">Null when refused.</param>
        /// <param name="reason">Why it was refused, one line that names the view; empty on success.</param>
        public static bool TryEstimate(BoardView view, LensCamera camera, out PlanarPose? pose, out string reason)
        {
            pose = null;
            if (!TryCentredHomography(view, camera, out Vector2D[] rays, out Homography homography, out reason))
                return false;
            Rotation3D[] rotations = ClosedForm(homography);
            BundleCamera[] cameras = { BundleCamera.Known(camera.Pinhole.Width, camera.Pinhole.Height) };
            BundleObservation[] observations = { new BundleObservation(0, 0, view) };
            double[][] lenses = { CameraParameters.Of(camera) };
            double[] closedRms = { double.PositiveInfinity, double.PositiveInfinity }, refinedRms = { double.PositiveInfinity, double.PositiveInfinity };
            var closed = new Pose[2];
            var refined = new Pose[2];
            for (int i = 0; i < 2; i++)
            {
                closed[i] = new Pose(Position(view.BoardMm, rays, rotations[i]), rotations[i]);
                var start = new BundleState(lenses, new[] { Pose.Identity }, new[] { closed[i] });
                closedRms[i] = NormalEquations.TryBuild(cameras, observations, start)?.RmsPx ?? double.PositiveInfinity;
                BundleState? solved = BundleAdjuster.Solve(cameras, observations, start, out NormalEquations? equations);
                if (solved == null)
                    continue;
                refined[i] = solved.Boards[0];
                refinedRms[i] = equations!.RmsPx;
            }

            int best = refinedRms[1] < refinedRms[0] ? 1 : 0, closedBest = closedRms[1] < closedRms[0] ? 1 : 0, other = 1 - closedBest;
            if (double.IsPositiveInfinity(refinedRms[best]))
            {
                reason = view.Name + ": the board lies behind the camera (negative depth): are its points in mirrored order, or left and right swapped?";
                return false;
            }

            bool isAmbiguous = closedRms[other] < AmbiguousRatio * closedRms[closedBest];
            pose = new PlanarPose(refined[best], refinedRms[best], closed[other], closedRms[other], isAmbiguous);
            return true;
        }

        /// <summary>From the board, its middle at the origin, to rays.</summary>
        private static bool TryCentredHomography(BoardView view, LensCamera camera, out Vector2D[] rays, out Homography homography, out string reason)
        {
            Vector2D center = default;
            homography = Homography.Identity;
            rays = new Vector2D[view.ImagePx.Length];
            for (int i = 0; i < rays.Length; i++)
            {
                if (!camera.TryUnproject(view.ImagePx[i], out rays[i]))
                {
                    reason = FormattableString.Invariant($"{view.Name}: point {i + 1} lies outside what the lens model covers");
                    return false;
                }

                center += view.BoardMm[i] * (1.0 / rays.Length);
            }

            var centred = new Vector2D[rays.Length];
            for (int i = 0; i < rays.Length; i++)
                centred[i] = view.BoardMm[i] - center;
            if (HomographyEstimator.TryFit(centred, rays, out homography, out reason))
                return true;
            reason = view.Name + ": " + reason;
            return false;
        }

        /// <summary>
        /// At the board's middle the homography's derivative is the first two columns of the rotation seen along the ray, shrunk by the
        /// depth. Their third components follow from their length 1 up to one common sign: hence two solutions.
        /// </summary>
        private static Rotation3D[] ClosedForm(Homography homography)
        {
            Vector2D ray = homography.Map(default);
            homography.Jacobian(default, out double xx, out double xy, out double yx, out double yy);
            Rotation3D toRay = FromForward(new Vector3D(ray.X, ray.Y, 1).Normalized);
            Vector3D c0 = toRay * new Vector3D(1, 0, 0), c1 = toRay * new Vector3D(0, 1, 0);
            double b00 = c0.X - ray.X * c0.Z, b01 = c1.X - ray.X * c1.Z, b10 = c0.Y - ray.Y * c0.Z, b11 = c1.Y - ray.Y * c1.Z;
            double determinant = b00 * b11 - b01 * b10;
            double a00 = (b11 * xx - b01 * yx) / determinant, a01 = (b11 * xy - b01 * yy) / determinant;
            double a10 = (b00 * yx - b10 * xx) / determinant, a11 = (b00 * yy - b10 * xy) / determinant;
            double squares = a00 * a00 + a01 * a01 + a10 * a10 + a11 * a11, area = a00 * a11 - a01 * a10;
            double gamma = Math.Sqrt((squares + Math.Sqrt(Math.Max(0, squares * squares - 4 * area * area))) / 2);
            double r00 = a00 / gamma, r01 = a01 / gamma, r10 = a10 / gamma, r11 = a11 / gamma;
            double third0 = Math.Sqrt(Math.Max(0, 1 - r00 * r00 - r10 * r10)), third1 = Math.Sqrt(Math.Max(0, 1 - r01 * r01 - r11 * r11));
            if (-(r00 * r01 + r10 * r11) < 0)
                third1 = -third1;
            var rotations = new Rotation3D[2];
            for (int i = 0; i < 2; i++)
            {
                double sign = i == 0 ? 1 : -1;
                Vector3D x = toRay * new Vector3D(r00, r10, sign * third0), y = toRay * new Vector3D(r01, r11, sign * third1);
                Vector3D z = Vector3D.Cross(x, y);
                rotations[i] = Matrices.NearestRotation(new[] { x.X, y.X, z.X, x.Y, y.Y, z.Y, x.Z, y.Z, z.Z });
            }

            return rotations;
        }

        /// <summary>With the rotation known the place is linear in the measurements: T.X − ray.X T.Z = ray.X q.Z − q.X with q = R X.</summary>
        private static Vector3D Position(Vector2D[] boardMm, Vector2D[] rays, Rotation3D rotation)
        {
            double x = 0, y = 0, squares = 0, rightX = 0, rightY = 0, rightZ = 0;
            for (int i = 0; i < rays.Length; i++)
            {
                Vector3D q = rotation * new Vector3D(boardMm[i].X, boardMm[i].Y, 0);
                Vector2D ray = rays[i];
                double alongX = ray.X * q.Z - q.X, alongY = ray.Y * q.Z - q.Y;
                x += ray.X;
                y += ray.Y;
                squares += ray.LengthSquared;
                rightX += alongX;
                rightY += alongY;
                rightZ -= ray.X * alongX + ray.Y * alongY;
            }

            int n = rays.Length;
            Matrix<double> left = Matrices.Of(new[] { n, 0, -x, 0, n, -y, -x, -y, squares });
            Vector<double> solution = left.Solve(Vector<double>.Build.DenseOfArray(new[] { rightX, rightY, rightZ }));
            return new Vector3D(solution[0], solution[1], solution[2]);
        }

        /// <summary>The shortest turn that takes the z axis to a direction.</summary>
        private static Rotation3D FromForward(Vector3D direction) => new Rotation3D(-direction.Y, direction.X, 0, 1 + direction.Z);
    }
}
