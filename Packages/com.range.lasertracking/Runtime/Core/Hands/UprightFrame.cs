using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>Which way is up for a camera: heads are above shoulders, also for one that lies on the floor and looks up.</summary>
    internal sealed class UprightFrame
    {
        /// <param name="right">Horizontal, along the screen; unit vector in camera space.</param>
        /// <param name="up">Away from the floor.</param>
        /// <param name="away">Horizontal, from the screen to the trainees.</param>
        private UprightFrame(Vector3D right, Vector3D up, Vector3D away)
        {
            Right = right;
            Up = up;
            Away = away;
        }

        /// <summary>A camera of unknown place counts as level.</summary>
        public static UprightFrame Level { get; } = new UprightFrame(new Vector3D(1, 0, 0), new Vector3D(0, -1, 0), new Vector3D(0, 0, 1));

        public Vector3D Right { get; }

        public Vector3D Up { get; }

        public Vector3D Away { get; }

        /// <summary>Screens hang upright: y of the screen points to the floor.</summary>
        public static UprightFrame Of(HandCamera camera)
        {
            Vector3D up = camera.PoseInScreenMm.InverseTransformDirection(new Vector3D(0, -1, 0));
            Vector3D away = camera.PoseInScreenMm.InverseTransformDirection(new Vector3D(0, 0, -1));
            return new UprightFrame(Vector3D.Cross(away, up), up, away);
        }

        /// <summary>x along the screen, y height, z distance from the screen; origin in the camera.</summary>
        public Vector3D ToUpright(Vector3D camera) =>
            new Vector3D(Vector3D.Dot(camera, Right), Vector3D.Dot(camera, Up), Vector3D.Dot(camera, Away));

        public Vector3D ToCamera(Vector3D upright) => Right * upright.X + Up * upright.Y + Away * upright.Z;
    }
}
