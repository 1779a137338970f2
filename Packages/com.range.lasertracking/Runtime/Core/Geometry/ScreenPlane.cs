using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Where the projected screen stands in camera 0's space, from its known size and where its corners are seen: the pose with the
    /// least squared error in the image. Immutable.
    /// </summary>
    public sealed class ScreenPlane
    {
        private readonly LensCamera _camera;
        private readonly Vector2D[] _cornerRays;

        private ScreenPlane(LensCamera camera, Vector2D[] cornerRays, Pose screenToCameraMm, Vector2D screenSizeM, double cornerRmsPx)
        {
            _camera = camera;
            _cornerRays = cornerRays;
            ScreenToCameraMm = screenToCameraMm;
            ScreenSizeM = screenSizeM;
            CornerRmsPx = cornerRmsPx;
            Plane = new Plane3D(screenToCameraMm.TransformDirection(new Vector3D(0, 0, 1)), screenToCameraMm.Position);
        }

        /// <summary>X_camera = R X_screen + T, both mm.</summary>
        public Pose ScreenToCameraMm { get; }

        public Vector2D ScreenSizeM { get; }

        /// <summary>
        /// How far the corners miss, px RMS. A homography has eight degrees of freedom, a pose six: a wrong size or a wrong focal length
        /// shows here unless the camera faces the screen squarely.
        /// </summary>
        public double CornerRmsPx { get; }

        /// <summary>In camera space, mm; the normal points into the projected picture.</summary>
        public Plane3D Plane { get; }

        /// <param name="screen">Where the screen is seen, and its size.</param>
        /// <param name="camera">What sees it: the screen calibration's own camera, or the factory calibration's.</param>
        /// <param name="plane">Valid only when true is returned.</param>
        /// <param name="reason">Why there is none, one line; empty on success.</param>
        public static bool TryFromSize(ScreenGeometry screen, LensCamera camera, out ScreenPlane? plane, out string reason)
        {
            plane = null;
            Vector2D[] pixels = screen.CornersPx, cornersMm = ScreenGeometry.CornersOf(screen.ScreenSizeM * 1000), rays = new Vector2D[4];
            for (int i = 0; i < 4; i++)
            {
                if (camera.TryUnproject(pixels[i], out rays[i]))
                    continue;
                reason = "corner " + (i + 1) + " of the screen lies outside what the colour camera's lens model covers";
                return false;
            }

            if (!TryStart(cornersMm, rays, out double[] parameters, out reason))
                return false;
            double[] matrix = new double[9], byVector = new double[27], byPoint = new double[6], byPinhole = new double[8];
            if (!LevenbergMarquardt.TryMinimize(Model, parameters, 8, out double squares, out _))
            {
                reason = "the corners do not fix where the screen stands";
                return false;
            }

            plane = new ScreenPlane(camera, rays, PoseOf(parameters), screen.ScreenSizeM, Math.Sqrt(squares / 4));
            return true;

            bool Model(double[] p, double[] residuals, double[,]? derivatives)
            {
                Rodrigues.ToMatrix(new Vector3D(p[0], p[1], p[2]), matrix, byVector);
                for (int i = 0; i < 4; i++)
                {
                    double x = cornersMm[i].X, y = cornersMm[i].Y;
                    var point = new Vector3D(matrix[0] * x + matrix[1] * y + p[3], matrix[3] * x + matrix[4] * y + p[4], matrix[6] * x + matrix[7] * y + p[5]);
                    if (!camera.TryProject(point, out Vector2D pixel, byPoint, byPinhole, default))
                        return false;
                    residuals[2 * i] = pixel.X - pixels[i].X;
                    residuals[2 * i + 1] = pixel.Y - pixels[i].Y;
                    for (int row = 0; row < 2 && derivatives != null; row++)
                    for (int k = 0; k < 3; k++)
                    {
                        double turned = 0;
                        for (int axis = 0; axis < 3; axis++)
                            turned += byPoint[row * 3 + axis] * (byVector[axis * 9 + k] * x + byVector[axis * 9 + 3 + k] * y);
                        derivatives[2 * i + row, k] = turned;
                        derivatives[2 * i + row, 3 + k] = byPoint[row * 3 + k];
                    }
                }

                return true;
            }
        }

        /// <summary>Where the ray of a pixel meets the screen's plane, camera space, mm; false where it does not or has no ray.</summary>
        public bool TryHit(Vector2D pixel, out Vector3D cameraMm)
        {
            cameraMm = default;
            return _camera.TryUnproject(pixel, out Vector2D ray) && Plane.TryIntersect(new Ray3D(default, new Vector3D(ray.X, ray.Y, 1)), out cameraMm);
        }

        /// <summary>A point of camera space in screen space, m; z is its distance behind the screen.</summary>
        public Vector3D ToScreenM(Vector3D cameraMm) => Axes.MillimetresToMetres(ScreenToCameraMm.InverseTransformPoint(cameraMm));

        /// <summary>How well another measurement of the plane agrees: the depth camera's, as a rule.</summary>
        /// <param name="other">In camera space, mm.</param>
        /// <param name="agreement">Valid only when true is returned.</param>
        /// <returns>False when a corner's ray does not meet both planes.</returns>
        public bool TryCompare(Plane3D other, out ScreenPlaneAgreement agreement)
        {
            agreement = default;
            Vector3D[] own = new Vector3D[5], seen = new Vector3D[5];
            double worst = 0;
            for (int i = 0; i < 5; i++)
            {
                Vector3D direction = i < 4
                    ? new Vector3D(_cornerRays[i].X, _cornerRays[i].Y, 1)
                    : ScreenToCameraMm.TransformPoint(new Vector3D(ScreenSizeM.X * 500, ScreenSizeM.Y * 500, 0));
                var ray = new Ray3D(default, direction);
                if (!Plane.TryIntersect(ray, out own[i]) || !other.TryIntersect(ray, out seen[i]))
                    return false;
                if (i < 4)
                    worst = Math.Max(worst, (own[i] - seen[i]).Length);
            }

            double angle = Math.Atan2(Vector3D.Cross(Plane.Normal, other.Normal).Length, Math.Abs(Vector3D.Dot(Plane.Normal, other.Normal)));
            var size = new Vector2D(((seen[1] - seen[0]).Length + (seen[2] - seen[3]).Length) / 2000, ((seen[3] - seen[0]).Length + (seen[2] - seen[1]).Length) / 2000);
            agreement = new ScreenPlaneAgreement(angle, seen[4].Length - own[4].Length, worst, size);
            return true;
        }

        /// <summary>The columns of the homography are the screen's axes and its origin in camera space, up to scale (Zhang 2000).</summary>
        private static bool TryStart(Vector2D[] cornersMm, Vector2D[] rays, out double[] parameters, out string reason)
        {
            parameters = new double[6];
            if (!HomographyEstimator.TryFit(cornersMm, rays, out Homography screenToRay, out reason))
                return false;
            double[] h = screenToRay.ToArray();
            Vector3D x = new Vector3D(h[0], h[3], h[6]), y = new Vector3D(h[1], h[4], h[7]), origin = new Vector3D(h[2], h[5], h[8]);
            double scale = (origin.Z < 0 ? -2 : 2) / (x.Length + y.Length);
            Vector3D z = Vector3D.Cross(x, y).Normalized, sum = x.Normalized + y.Normalized, difference = (x.Normalized - y.Normalized).Normalized;
            Vector3D right = (sum.Normalized + difference) * (origin.Z < 0 ? -1 : 1);
            x = right.Normalized;
            y = Vector3D.Cross(z, x);
            if (!Rotation3D.TryFromMatrix(new[] { x.X, y.X, z.X, x.Y, y.Y, z.Y, x.Z, y.Z, z.Z }, out Rotation3D rotation))
            {
                reason = "the corners do not fix where the screen stands";
                return false;
            }

            Vector3D vector = rotation.ToVector(), position = origin * scale;
            parameters = new[] { vector.X, vector.Y, vector.Z, position.X, position.Y, position.Z };
            return true;
        }

        private static Pose PoseOf(double[] p) => new Pose(new Vector3D(p[3], p[4], p[5]), Rotation3D.FromVector(new Vector3D(p[0], p[1], p[2])));
    }
}
