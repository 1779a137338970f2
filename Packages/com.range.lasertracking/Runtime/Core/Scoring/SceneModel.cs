using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// The scene as the headless program knows it: where the projected surface stands, from where the picture is drawn, and what
    /// a ray can meet behind it. Scene space (Unity's), metres. Immutable: poses are functions of time.
    /// </summary>
    public sealed class SceneModel
    {
        private readonly SceneObject[] _objects;
        private readonly PoseTrack? _surfaceTrack;
        private readonly PoseTrack? _viewpointTrack;

        /// <param name="name">For people.</param>
        /// <param name="surface">Pose of the screen surface: local x right, y up, z into the picture.</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        /// <param name="viewpoint">Eye from which the picture is drawn; in front of the surface (negative local z).</param>
        /// <param name="layerMask">Layers that shots can hit, bit = 1 &lt;&lt; layer.</param>
        /// <param name="objects">Active objects in hierarchy order.</param>
        /// <param name="surfaceTrack">Where the surface was at which time; null: it stays.</param>
        /// <param name="viewpointTrack">The same of the eye.</param>
        public SceneModel(string name, Pose surface, Vector2D screenSizeM, Vector3D viewpoint, int layerMask, SceneObject[] objects,
            PoseTrack? surfaceTrack = null, PoseTrack? viewpointTrack = null)
        {
            _surfaceTrack = surfaceTrack;
            _viewpointTrack = viewpointTrack;
            Name = name;
            Surface = surface;
            ScreenSizeM = screenSizeM;
            Viewpoint = viewpoint;
            LayerMask = layerMask;
            _objects = (SceneObject[])objects.Clone();
        }

        public string Name { get; }

        /// <summary>As it stands, or stood at the beginning.</summary>
        public Pose Surface { get; }

        public Vector2D ScreenSizeM { get; }

        public Vector3D Viewpoint { get; }

        public int LayerMask { get; }

        public IReadOnlyList<SceneObject> Objects => _objects;

        /// <summary>Screen and eye at a time on the scene's clock, seconds. No allocation.</summary>
        public ScreenView ViewAt(double timeS) =>
            new ScreenView(_surfaceTrack?.PoseAt(timeS) ?? Surface, ScreenSizeM, _viewpointTrack?.PoseAt(timeS).Position ?? Viewpoint);

        /// <summary>A point of screen space (m, z into the picture) in the scene.</summary>
        public Vector3D ScreenToScene(Vector3D screenM) => Surface.TransformPoint(Axes.ScreenToSurface(screenM, ScreenSizeM));

        /// <summary>A scene point in screen space.</summary>
        public Vector3D SceneToScreen(Vector3D scenePoint) =>
            Axes.SurfaceToScreen(Surface.InverseTransformPoint(scenePoint), ScreenSizeM);
    }
}
