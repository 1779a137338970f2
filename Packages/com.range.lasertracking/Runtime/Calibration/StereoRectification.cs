using System;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// Turns two cameras so that a point lies in the same row of both pictures (or column, for cameras above each other): half of the
    /// turn between them each, then the baseline on to an axis (Bouguet; OpenCV's stereoRectify with zero disparity at infinity).
    /// </summary>
    public sealed class StereoRectification
    {
        // Cosine of 72°: farther off axis a flat picture stretches without end.
        private const double LeastForward = 0.3;

        private readonly StereoRig _rig;

        private StereoRectification(StereoRig rig, Rotation3D left, Rotation3D right, double focalPx, Vector2D center, double shiftPx, bool isVertical)
        {
            _rig = rig;
            Left = left;
            Right = right;
            FocalPx = focalPx;
            CenterPx = center;
            ShiftPx = shiftPx;
            IsVertical = isVertical;
        }

        /// <summary>Camera 0's space to its rectified one.</summary>
        public Rotation3D Left { get; }

        /// <summary>Camera 1's space to its rectified one.</summary>
        public Rotation3D Right { get; }

        /// <summary>Of both rectified cameras.</summary>
        public double FocalPx { get; }

        /// <summary>Of both rectified cameras.</summary>
        public Vector2D CenterPx { get; }

        /// <summary>Focal length times baseline along the axis: disparity = −shift / depth; below zero for a right camera on the right.</summary>
        public double ShiftPx { get; }

        /// <summary>The cameras stand above each other: partners lie in one column.</summary>
        public bool IsVertical { get; }

        /// <summary>Both rectified cameras keep the picture's whole width; corners may fall outside.</summary>
        /// <exception cref="ArgumentException">The cameras stand in one place.</exception>
        public static StereoRectification Of(StereoRig rig)
        {
            Rotation3D between = rig.LeftToRight.Rotation;
            Rotation3D half = between.W < 0
                ? new Rotation3D(-between.X, -between.Y, -between.Z, 1 - between.W)
                : new Rotation3D(between.X, between.Y, between.Z, 1 + between.W);
            Vector3D baseline = half.Inverse * rig.LeftToRight.Position;
            if (!(baseline.Length > 0))
                throw new ArgumentException("the cameras stand in one place");
            bool isVertical = Math.Abs(baseline.Y) >= Math.Abs(baseline.X);
            double along = isVertical ? baseline.Y : baseline.X;
            Vector3D axis = (isVertical ? new Vector3D(0, 1, 0) : new Vector3D(1, 0, 0)) * (along > 0 ? 1 : -1);
            Vector3D normal = Vector3D.Cross(baseline, axis);
            Rotation3D align = normal.Length > 0 ? Rotation3D.AboutAxis(normal, Math.Acos(Math.Min(1, Math.Abs(along) / baseline.Length))) : Rotation3D.Identity;
            Rotation3D left = align * half, right = align * half.Inverse;
            PinholeCamera first = rig.Left.Pinhole, second = rig.Right.Pinhole;
            double focal = (isVertical ? first.FocalXPx + second.FocalXPx : first.FocalYPx + second.FocalYPx) / 2;
            Vector2D center = (Center(rig.Left, left, focal) + Center(rig.Right, right, focal)) * 0.5;
            Vector3D moved = right * rig.LeftToRight.Position;
            double shift = (isVertical ? moved.Y : moved.X) * focal;
            return new StereoRectification(rig, left, right, focal, center, shift, isVertical);
        }

        /// <summary>Where a pixel of the left picture lies in the rectified one; false outside the lens model.</summary>
        public bool TryMapLeft(Vector2D px, out Vector2D rectifiedPx) => TryMap(_rig.Left, Left, px, out rectifiedPx);

        /// <summary>Where a pixel of the right picture lies in the rectified one; false outside the lens model.</summary>
        public bool TryMapRight(Vector2D px, out Vector2D rectifiedPx) => TryMap(_rig.Right, Right, px, out rectifiedPx);

        /// <summary>3×4, row by row: rectified space of camera 0 to rectified pixels of the left (false) or right (true) camera.</summary>
        public double[] Projection(bool ofRight)
        {
            double shift = ofRight ? ShiftPx : 0;
            return new[] { FocalPx, 0, CenterPx.X, IsVertical ? 0 : shift, 0, FocalPx, CenterPx.Y, IsVertical ? shift : 0, 0, 0, 1, 0 };
        }

        /// <summary>4×4, row by row: (x, y, disparity, 1) to homogeneous coordinates in rectified camera 0.</summary>
        public double[] DisparityToDepth() => new[] { 1, 0, 0, -CenterPx.X, 0, 1, 0, -CenterPx.Y, 0, 0, 0, FocalPx, 0, 0, -FocalPx / ShiftPx, 0 };

        private bool TryMap(LensCamera camera, Rotation3D turn, Vector2D px, out Vector2D rectifiedPx)
        {
            rectifiedPx = default;
            if (!camera.TryUnproject(px, out Vector2D ray))
                return false;
            Vector3D turned = turn * new Vector3D(ray.X, ray.Y, 1);
            rectifiedPx = new Vector2D(turned.X / turned.Z * FocalPx + CenterPx.X, turned.Y / turned.Z * FocalPx + CenterPx.Y);
            return turned.Z > 0;
        }

        /// <summary>
        /// Puts the middle of the turned picture's corners at the middle of the picture. A corner that the lens model does not reach, or
        /// that lies far off axis, is drawn in towards the middle until it does.
        /// </summary>
        private static Vector2D Center(LensCamera camera, Rotation3D turn, double focal)
        {
            PinholeCamera pinhole = camera.Pinhole;
            double right = pinhole.Width - 1, bottom = pinhole.Height - 1;
            var axis = new Vector2D(pinhole.CenterXPx, pinhole.CenterYPx);
            Vector2D sum = default;
            foreach (Vector2D corner in new[] { default, new Vector2D(right, 0), new Vector2D(0, bottom), new Vector2D(right, bottom) })
            {
                Vector3D turned = turn * new Vector3D(0, 0, 1);
                for (double share = 1; share > 0; share -= 0.02)
                {
                    if (!camera.TryUnproject(axis + (corner - axis) * share, out Vector2D ray))
                        continue;
                    Vector3D candidate = (turn * new Vector3D(ray.X, ray.Y, 1)).Normalized;
                    if (candidate.Z < LeastForward)
                        continue;
                    turned = candidate;
                    break;
                }

                sum += new Vector2D(turned.X / turned.Z, turned.Y / turned.Z) * (focal / 4);
            }

            return new Vector2D(right / 2, bottom / 2) - sum;
        }
    }
}
