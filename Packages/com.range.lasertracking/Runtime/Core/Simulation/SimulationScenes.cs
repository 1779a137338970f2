using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>Scenes that need no files, for tests and for the demo.</summary>
    public static class SimulationScenes
    {
        /// <summary>Eight targets of four kinds 3 to 7 m behind a screen of 3.2 × 1.8 m, four of them moving; trainee's eye 2.4 m before it.</summary>
        public static SceneModel Default()
        {
            TargetDefinition popper = Popper(), rings = Rings(), silhouette = Silhouette(), noShoot = NoShoot();
            var objects = new[]
            {
                Target("Popper 1", popper, -2.55, 0.5, 3.3, MotionPathNone()),
                Target("Popper 2", popper, -1.75, 0.5, 4.0, MotionPathNone()),
                Target("Popper 3", popper, 1.35, 0.5, 4.4, new MotionPath(MotionKind.PingPong, new Vector3D(1.3, 0, 0), 5, 0)),
                Target("Paper 1", rings, -0.75, 1.6, 3.0, MotionPathNone()),
                Target("Paper 2", rings, 1.7, 2.45, 4.2, new MotionPath(MotionKind.Circle, new Vector3D(0.4, 0.25, 0), 7, 1)),
                Target("Silhouette 1", silhouette, 0.25, 1.25, 2.8, MotionPathNone()),
                Target("Silhouette 2", silhouette, 3, 1.4, 6.5, new MotionPath(MotionKind.Sine, new Vector3D(1, 0, 0), 8, 0)),
                Target("No-shoot 1", noShoot, 1.0, 1.25, 3.5, new MotionPath(MotionKind.Sine, new Vector3D(0.3, 0, 0), 6, 2)),
            };
            // Unity's axes: the screen's lower edge hangs 0.6 m over the ground, z into the picture.
            return new SceneModel("Default range", new Pose(new Vector3D(0, 1.5, 0), Rotation3D.Identity), new Vector2D(3.2, 1.8),
                new Vector3D(0, 1.6, -2.4), 1, objects);
        }

        /// <summary>A screen of 3.2 × 1.8 m without targets: for studies of moving content.</summary>
        public static SceneModel Empty() => new SceneModel("Empty range", new Pose(new Vector3D(0, 1.5, 0), Rotation3D.Identity), new Vector2D(3.2, 1.8),
            new Vector3D(0, 1.6, -2.4), 1, new SceneObject[0]);

        private static MotionPath MotionPathNone() => new MotionPath(MotionKind.None, default, 0, 0);

        private static SceneObject Target(string name, TargetDefinition definition, double x, double y, double z, MotionPath motion)
        {
            var box = SceneCollider.Box(default, new Vector3D(definition.SizeM.X, definition.SizeM.Y, 0.02));
            return new SceneObject(name, 0, new Pose(new Vector3D(x, y, z), Rotation3D.Identity), new Vector3D(1, 1, 1),
                Rotation3D.Identity, motion, new[] { box }, definition);
        }

        private static TargetDefinition Popper()
        {
            var body = new[]
            {
                new Vector2D(-0.07, -0.5), new Vector2D(0.07, -0.5), new Vector2D(0.085, 0.05), new Vector2D(0.15, 0.2),
                new Vector2D(0.15, 0.38), new Vector2D(0.08, 0.5), new Vector2D(-0.08, 0.5), new Vector2D(-0.15, 0.38),
                new Vector2D(-0.15, 0.2), new Vector2D(-0.085, 0.05),
            };
            return new TargetDefinition("Steel popper", TargetKind.SteelPopper, new Vector2D(0.3, 1), new[]
            {
                new TargetZone("steel", 5, ZoneShape.Polygon, default, default, body),
            });
        }

        private static TargetDefinition Rings()
        {
            var zones = new TargetZone[6];
            for (int i = 0; i < zones.Length; i++)
            {
                double size = 0.1 + 0.12 * i;
                zones[i] = new TargetZone((10 - i).ToString(System.Globalization.CultureInfo.InvariantCulture), 10 - i, ZoneShape.Ellipse, default,
                    new Vector2D(size, size), new Vector2D[0]);
            }

            return new TargetDefinition("Ring paper", TargetKind.RingPaper, new Vector2D(0.7, 0.7), zones);
        }

        private static TargetDefinition Silhouette() => new TargetDefinition("Silhouette", TargetKind.Silhouette, new Vector2D(0.46, 0.92), new[]
        {
            new TargetZone("head A", 5, ZoneShape.Rectangle, new Vector2D(0, 0.37), new Vector2D(0.1, 0.08), new Vector2D[0]),
            new TargetZone("A", 5, ZoneShape.Rectangle, new Vector2D(0, 0.08), new Vector2D(0.16, 0.3), new Vector2D[0]),
            new TargetZone("C", 3, ZoneShape.Polygon, default, default, Body(0.15, 0.08, 0.075, 0.3, 0.43)),
            new TargetZone("D", 1, ZoneShape.Polygon, default, default, Body(0.23, 0.14, 0.1, 0.46, 0.46)),
        });

        private static TargetDefinition NoShoot() => new TargetDefinition("No-shoot", TargetKind.NoShoot, new Vector2D(0.46, 0.92), new[]
        {
            new TargetZone("no-shoot", -10, ZoneShape.Polygon, default, default, Body(0.23, 0.14, 0.1, 0.46, 0.46)),
        });

        // An eight-sided trunk with a square head on it.
        private static Vector2D[] Body(double halfWidth, double halfFoot, double halfHead, double foot, double top)
        {
            const double shoulder = 0.24, slope = 0.08;
            return new[]
            {
                new Vector2D(-halfFoot, -foot), new Vector2D(halfFoot, -foot), new Vector2D(halfWidth, -foot * 0.4),
                new Vector2D(halfWidth, shoulder - slope), new Vector2D(halfWidth - slope, shoulder), new Vector2D(halfHead, shoulder + 0.02),
                new Vector2D(halfHead, top), new Vector2D(-halfHead, top), new Vector2D(-halfHead, shoulder + 0.02),
                new Vector2D(-halfWidth + slope, shoulder), new Vector2D(-halfWidth, shoulder - slope), new Vector2D(-halfWidth, -foot * 0.4),
            };
        }
    }
}
