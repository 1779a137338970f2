using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Where camera 1 stands and how it images: the pinhole of an Azure Kinect's narrow depth mode. Immutable.</summary>
    internal sealed class DepthCameraGeometry
    {
        private const double TypicalFocalPx = 504;

        public DepthCameraGeometry(DepthCameraSettings settings, RoomSettings room, Vector2D screenSizeM)
        {
            int divisor = settings.Binned ? 2 : 1;
            Width = 640 / divisor;
            Height = 576 / divisor;
            NearMm = 500;
            FarMm = settings.Binned ? 5460 : 3860;
            double floor = screenSizeM.Y + room.FloorBelowScreenM;
            Vector3D position = settings.PositionM ?? new Vector3D(screenSizeM.X / 2, screenSizeM.Y + 0.06, -0.25);
            Vector3D lookAt = settings.LookAtM ?? new Vector3D(screenSizeM.X / 2, floor - 1.3, -1.7);
            Pose pose = LookAt.Pose(Axes.MetresToMillimetres(position), Axes.MetresToMillimetres(lookAt), 0);
            var intrinsics = new PinholeCamera(TypicalFocalPx / divisor, TypicalFocalPx / divisor, (Width - 1) / 2.0, (Height - 1) / 2.0, Width, Height);
            HandCamera = new HandCamera(intrinsics, pose);
            FloorM = floor;
            CeilingM = floor - room.CeilingM;
            BackWallM = room.BackWallM;
        }

        public int Width { get; }

        public int Height { get; }

        public double NearMm { get; }

        public double FarMm { get; }

        /// <summary>Height of the floor in screen space (y down).</summary>
        public double FloorM { get; }

        /// <summary>Height of the ceiling in screen space (y down).</summary>
        public double CeilingM { get; }

        public double BackWallM { get; }

        public HandCamera HandCamera { get; }
    }
}
