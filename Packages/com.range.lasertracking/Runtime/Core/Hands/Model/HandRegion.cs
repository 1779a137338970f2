using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// The square of a picture that the landmark model looks at, turned so that the hand stands upright in it. Pixels with the
    /// picture's corner at (0,0) — first pixel's centre (0.5,0.5), half a pixel more than elsewhere in this package — and y down;
    /// radians, clockwise as seen. Geometry and constants are MediaPipe's (hand_landmark_tracking graph).
    /// </summary>
    public readonly struct HandRegion
    {
        private const int Wrist = 0;

        // Without the tips and the last joints, which move most.
        private static readonly int[] StableJoints = { 0, 1, 2, 3, 5, 6, 9, 10, 13, 14, 17, 18 };

        /// <param name="centerXPx">Finite.</param>
        /// <param name="centerYPx">Finite.</param>
        /// <param name="sidePx">Above zero.</param>
        /// <param name="rotationRad">Any finite angle; kept within -π…π.</param>
        public HandRegion(double centerXPx, double centerYPx, double sidePx, double rotationRad)
        {
            CenterXPx = centerXPx;
            CenterYPx = centerYPx;
            SidePx = sidePx;
            RotationRad = Normalize(rotationRad);
        }

        public double CenterXPx { get; }

        public double CenterYPx { get; }

        public double SidePx { get; }

        /// <summary>Direction of the crop's own "up" against the picture's, -π ≤ r &lt; π.</summary>
        public double RotationRad { get; }

        /// <summary>All four are finite and the side is above zero.</summary>
        public bool IsValid => SidePx > 0 && !double.IsInfinity(SidePx) && IsFinite(CenterXPx) && IsFinite(CenterYPx) && IsFinite(RotationRad);

        /// <summary>The region for the next frame from this frame's 21 landmarks (x, y of each in picture px).</summary>
        public static HandRegion FromLandmarks(ReadOnlySpan<Vector3D> landmarksPx)
        {
            if (landmarksPx.Length != HandLandmarks.Count)
                throw new ArgumentException("21 landmarks are needed", nameof(landmarksPx));
            Vector3D roots = ((landmarksPx[5] + landmarksPx[13]) * 0.5 + landmarksPx[9]) * 0.5;
            double rotation = UprightRotation(landmarksPx[Wrist].X, landmarksPx[Wrist].Y, roots.X, roots.Y);
            double cos = Math.Cos(rotation), sin = Math.Sin(rotation);
            double left = double.MaxValue, right = double.MinValue, top = double.MaxValue, bottom = double.MinValue;
            foreach (int joint in StableJoints)
            {
                double u = landmarksPx[joint].X * cos + landmarksPx[joint].Y * sin;
                double v = -landmarksPx[joint].X * sin + landmarksPx[joint].Y * cos;
                left = Math.Min(left, u);
                right = Math.Max(right, u);
                top = Math.Min(top, v);
                bottom = Math.Max(bottom, v);
            }

            double centerU = (left + right) / 2, centerV = (top + bottom) / 2;
            return Around(centerU * cos - centerV * sin, centerU * sin + centerV * cos, right - left, bottom - top, rotation, 0.1, 2.0);
        }

        /// <summary>The region from a detected palm: its box, upright in the picture, wrist and root of the middle finger. Picture px.</summary>
        public static HandRegion FromPalm(double boxLeftPx, double boxTopPx, double boxWidthPx, double boxHeightPx, Vector2D wristPx, Vector2D middleFingerPx) =>
            Around(boxLeftPx + boxWidthPx / 2, boxTopPx + boxHeightPx / 2, boxWidthPx, boxHeightPx,
                UprightRotation(wristPx.X, wristPx.Y, middleFingerPx.X, middleFingerPx.Y), 0.5, 2.6);

        /// <summary>Picture position of a place in the crop, both 0…1 within it from its top-left corner.</summary>
        public Vector2D ToPicture(double x, double y)
        {
            double u = (x - 0.5) * SidePx, v = (y - 0.5) * SidePx;
            double cos = Math.Cos(RotationRad), sin = Math.Sin(RotationRad);
            return new Vector2D(CenterXPx + u * cos - v * sin, CenterYPx + u * sin + v * cos);
        }

        /// <summary>The same region turned about its centre.</summary>
        public HandRegion Turned(double byRad) => new HandRegion(CenterXPx, CenterYPx, SidePx, RotationRad + byRad);

        /// <summary>Rotation that makes the way from one point to the other lead straight up.</summary>
        public static double UprightRotation(double fromXPx, double fromYPx, double toXPx, double toYPx) =>
            Normalize(Math.PI / 2 - Math.Atan2(-(toYPx - fromYPx), toXPx - fromXPx));

        /// <summary>Shifted by a share of the height towards the fingers and made larger, square.</summary>
        private static HandRegion Around(double centerX, double centerY, double width, double height, double rotation, double shift, double scale) =>
            new HandRegion(centerX + shift * height * Math.Sin(rotation), centerY - shift * height * Math.Cos(rotation), scale * Math.Max(width, height), rotation);

        private static double Normalize(double angle) => angle - 2 * Math.PI * Math.Floor((angle + Math.PI) / (2 * Math.PI));

        private static bool IsFinite(double value) => !double.IsNaN(value) && !double.IsInfinity(value);
    }
}
