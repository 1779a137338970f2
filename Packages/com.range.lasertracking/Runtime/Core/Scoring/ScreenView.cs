using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>Through what a shot goes into the scene, as it stood at one time: the screen and the eye that its picture is drawn from.</summary>
    public readonly struct ScreenView
    {
        /// <param name="surface">Pose of the screen in the scene: local x right, y up, z into the picture.</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        /// <param name="viewpoint">The eye, scene space.</param>
        public ScreenView(Pose surface, Vector2D screenSizeM, Vector3D viewpoint)
        {
            Surface = surface;
            ScreenSizeM = screenSizeM;
            Viewpoint = viewpoint;
        }

        public Pose Surface { get; }

        public Vector2D ScreenSizeM { get; }

        public Vector3D Viewpoint { get; }

        /// <summary>A point of screen space (m, z into the picture) in the scene.</summary>
        public Vector3D ScreenToScene(Vector3D screenM) => Surface.TransformPoint(Axes.ScreenToSurface(screenM, ScreenSizeM));
    }
}
