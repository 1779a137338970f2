namespace LaserTracking.Geometry
{
    /// <summary>Camera 1: how it images and where it stands.</summary>
    public sealed class HandCamera
    {
        /// <param name="intrinsics">Of its depth picture.</param>
        /// <param name="poseInScreenMm">Camera space (mm) to screen space in mm: X_screen = R X_camera + T.</param>
        public HandCamera(PinholeCamera intrinsics, Pose poseInScreenMm)
        {
            Intrinsics = intrinsics;
            PoseInScreenMm = poseInScreenMm;
        }

        public PinholeCamera Intrinsics { get; }

        public Pose PoseInScreenMm { get; }

        /// <summary>A point of camera 1's space (mm) in screen space (m).</summary>
        public Vector3D ToScreenM(Vector3D cameraMm) => Axes.MillimetresToMetres(PoseInScreenMm.TransformPoint(cameraMm));

        /// <summary>A screen-space point (m) in camera 1's space (mm).</summary>
        public Vector3D ToCameraMm(Vector3D screenM) => PoseInScreenMm.InverseTransformPoint(Axes.MetresToMillimetres(screenM));
    }
}
