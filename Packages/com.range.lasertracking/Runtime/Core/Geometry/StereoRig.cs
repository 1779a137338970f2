namespace LaserTracking.Geometry
{
    /// <summary>Two cameras beside each other: X_right = R X_left + T, in the unit of T (mm in files). Camera 0 is the left one. Immutable.</summary>
    public sealed class StereoRig
    {
        /// <param name="left">Camera 0.</param>
        /// <param name="right">Camera 1.</param>
        /// <param name="leftToRight">X_right = R X_left + T.</param>
        public StereoRig(LensCamera left, LensCamera right, Pose leftToRight)
        {
            Left = left;
            Right = right;
            LeftToRight = leftToRight;
        }

        public LensCamera Left { get; }

        public LensCamera Right { get; }

        public Pose LeftToRight { get; }

        /// <summary>A point of camera 1's space in camera 0's: X_left = Rᵀ (X_right − T).</summary>
        public Vector3D RightToLeft(Vector3D right) => LeftToRight.InverseTransformPoint(right);
    }
}
