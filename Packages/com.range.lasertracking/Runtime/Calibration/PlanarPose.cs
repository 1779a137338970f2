using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>Where a flat board stands before a camera: X_camera = R X_board + T, in the board's unit.</summary>
    public sealed class PlanarPose
    {
        internal PlanarPose(Pose pose, double rmsPx, Pose otherPose, double otherRmsPx, bool isAmbiguous)
        {
            Pose = pose;
            RmsPx = rmsPx;
            OtherPose = otherPose;
            OtherRmsPx = otherRmsPx;
            IsAmbiguous = isAmbiguous;
        }

        /// <summary>The pose that fits best.</summary>
        public Pose Pose { get; }

        /// <summary>Its root mean square distance, px.</summary>
        public double RmsPx { get; }

        /// <summary>The pose with the board tilted the other way, as it comes out of the closed form.</summary>
        public Pose OtherPose { get; }

        /// <summary>Its root mean square distance, px.</summary>
        public double OtherRmsPx { get; }

        /// <summary>The other pose fits less than twice as badly: a small or distant board, or noise; do not rely on the tilt.</summary>
        public bool IsAmbiguous { get; }
    }
}
