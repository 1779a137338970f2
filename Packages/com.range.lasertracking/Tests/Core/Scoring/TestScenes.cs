using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>Small scenes for tests: a 4 m × 2 m screen at the origin, seen from 5 m in front of its middle.</summary>
    internal static class TestScenes
    {
        public const int TargetLayer = 8;

        public static readonly Vector2D ScreenSizeM = new Vector2D(4, 2);

        public static readonly Vector3D Viewpoint = new Vector3D(0, 0, -5);

        public static readonly Vector3D One = new Vector3D(1, 1, 1);

        public static SceneModel Of(params SceneObject[] objects) => Of(~0, objects);

        public static SceneModel Of(int layerMask, params SceneObject[] objects) =>
            new SceneModel("test", Pose.Identity, ScreenSizeM, Viewpoint, layerMask, objects);

        public static SceneObject Object(Pose pose, Vector3D scale, params SceneCollider[] colliders) =>
            new SceneObject("thing", 0, pose, scale, Rotation3D.Identity, default, colliders, null);

        public static SceneObject At(double x, double y, double z, params SceneCollider[] colliders) =>
            Object(new Pose(new Vector3D(x, y, z), Rotation3D.Identity), One, colliders);

        public static SceneObject Target(string name, TargetDefinition definition, Pose pose, MotionPath motion = default) =>
            new SceneObject(name, TargetLayer, pose, One, Rotation3D.Identity, motion,
                new[] { SceneCollider.Box(default, new Vector3D(definition.SizeM.X, definition.SizeM.Y, 0.01)) }, definition);

        public static SceneObject Target(string name, TargetDefinition definition, double x, double y, double z) =>
            Target(name, definition, new Pose(new Vector3D(x, y, z), Rotation3D.Identity));

        /// <summary>Rings of 10 and 5 points with 0.2 m and 0.8 m diameter on a card of 1 m.</summary>
        public static TargetDefinition Rings { get; } = new TargetDefinition("rings", TargetKind.RingPaper, new Vector2D(1, 1), new[]
        {
            new TargetZone("10", 10, ZoneShape.Ellipse, default, new Vector2D(0.2, 0.2), new Vector2D[0]),
            new TargetZone("5", 5, ZoneShape.Ellipse, default, new Vector2D(0.8, 0.8), new Vector2D[0]),
        });

        /// <summary>One penalty zone that fills the card of 1 m.</summary>
        public static TargetDefinition NoShoot { get; } = new TargetDefinition("no-shoot", TargetKind.NoShoot, new Vector2D(1, 1), new[]
        {
            new TargetZone("no-shoot", -10, ZoneShape.Rectangle, default, new Vector2D(1, 1), new Vector2D[0]),
        });

        /// <summary>The dot on the screen that the viewpoint sees in front of a scene point.</summary>
        public static Vector2D DotFor(SceneModel scene, Vector3D scenePoint)
        {
            Vector3D point = scene.SceneToScreen(scenePoint), eye = scene.SceneToScreen(scene.Viewpoint);
            double u = -eye.Z / (point.Z - eye.Z);
            return new Vector2D(eye.X + (point.X - eye.X) * u, eye.Y + (point.Y - eye.Y) * u);
        }
    }
}
