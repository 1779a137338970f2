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

        /// <param name="name">For people.</param>
        /// <param name="surface">Pose of the screen surface: local x right, y up, z into the picture.</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        /// <param name="viewpoint">Eye from which the picture is drawn; in front of the surface (negative local z).</param>
        /// <param name="layerMask">Layers that shots can hit, bit = 1 &lt;&lt; layer.</param>
        /// <param name="objects">Active objects in hierarchy order.</param>
        public SceneModel(string name, Pose surface, Vector2D screenSizeM, Vector3D viewpoint, int layerMask, SceneObject[] objects)
        {
            Name = name;
            Surface = surface;
            ScreenSizeM = screenSizeM;
            Viewpoint = viewpoint;
            LayerMask = layerMask;
            _objects = (SceneObject[])objects.Clone();
        }

        public string Name { get; }

        public Pose Surface { get; }

        public Vector2D ScreenSizeM { get; }

        public Vector3D Viewpoint { get; }

        public int LayerMask { get; }

        public IReadOnlyList<SceneObject> Objects => _objects;

        /// <summary>A point of screen space (m, z into the picture) in the scene.</summary>
        public Vector3D ScreenToScene(Vector3D screenM) => Surface.TransformPoint(Axes.ScreenToSurface(screenM, ScreenSizeM));

        /// <summary>A scene point in screen space.</summary>
        public Vector3D SceneToScreen(Vector3D scenePoint) =>
            Axes.SurfaceToScreen(Surface.InverseTransformPoint(scenePoint), ScreenSizeM);
    }
}
