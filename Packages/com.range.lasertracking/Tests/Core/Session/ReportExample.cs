using System;
using System.Collections.Generic;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>A range with every kind of target and a session in which two people shoot at it.</summary>
    internal sealed class ReportExample
    {
        public static readonly Vector2D ScreenSizeM = new Vector2D(3.73, 2.26);
        private const long StartUs = 1234571;
        private readonly Random _random = new Random(11);
        private readonly ScenePerspective _perspective;
        private int _id;

        public ReportExample()
        {
            Scene = new SceneModel("Range", Pose.Identity, ScreenSizeM, new Vector3D(0, 0, -2.6), -1, Objects());
            _perspective = new ScenePerspective(Scene);
        }

        public SceneModel Scene { get; }

        /// <summary>Twenty shots with hits, misses and one mistake.</summary>
        public SessionRecorder Record()
        {
            var recorder = new SessionRecorder();
            recorder.Begin(new SessionHeader("0.1.0", new[]
            {
                new SessionInput("Calibration/Recordings/demo-screen.mkv", "2c26b46b68ffc68ff99b453c1d30413413422d706483bfa0f98a5e886266e7ae"),
                new SessionInput("Calibration/Recordings/demo-hands.mkv", "fcde2b2edba56bf408601fb721fe9b5c338d10ee429ea04fae5511b68fbf8fb9"),
            }, "Calibration/screen.json", "shots", 7));
            foreach (ShotEvent shot in Shots())
                recorder.OnShot(shot);
            foreach (RejectionReason reason in new[] { RejectionReason.NotIsolated, RejectionReason.NotIsolated, RejectionReason.MovingSurroundings, RejectionReason.TooSmall })
            {
                RejectedEvent rejected = EventExamples.Rejected(5, StartUs + 200000);
                rejected.Candidate.Reason = reason;
                recorder.OnRejected(rejected);
            }

            recorder.OnHealth(new HealthEvent { FrameIndex = 212, TimeUs = StartUs + 7066000, Kind = HealthKind.FrameGap, Value = 2, Text = "two frames are missing: give the camera its own USB controller" });
            recorder.OnHealth(new HealthEvent { FrameIndex = 300, TimeUs = StartUs + 10000000, Kind = HealthKind.Blind, Value = 0.12, Text = "12 % of the screen is too bright to see a dot in: lower the exposure" });
            for (int i = 0; i < 450; i++)
                recorder.AddFrame(StartUs + i * 33333L, i < 40 ? 0.12 : 0, 0.8 + 0.01 * (i % 50));
            recorder.End(new SessionEnd { Frames = 450, Dropped = 2, SecondsMedia = 14.967, SecondsWall = 1.7, StartTimeUs = StartUs });
            return recorder;
        }

        private IEnumerable<ShotEvent> Shots()
        {
            yield return Hit(1, 1.21, "Popper 1", 0.01, 0.03);
            yield return Hit(1, 1.47, "Popper 1", -0.02, 0.01);
            yield return Hit(2, 1.58, "Paper left", 0.035, -0.02);
            yield return Hit(2, 1.99, "Paper left", 0.012, 0.055);
            yield return Hit(1, 2.05, "Popper 2", 0.03, -0.05);
            yield return Hit(2, 2.36, "Paper left", -0.06, 0.02);
            yield return Hit(1, 2.61, "Silhouette 1", 0.02, 0.14);
            yield return Hit(1, 2.86, "Silhouette 1", 0.05, 0.05);
            yield return Hit(2, 3.30, "Runner", 0.04, 0.1);
            yield return Hit(2, 3.61, "Runner", -0.03, 0.13);
            yield return Miss(1, 3.95, 1.32, 0.62);
            yield return Hit(1, 4.30, "Popper 3", 0, 0.02);
            yield return Hit(2, 4.85, "Hostage", 0.02, 0.05);
            yield return Hit(2, 5.12, "Runner", -0.12, -0.04);
            yield return Hit(1, 5.50, "Paper right", 0.005, 0.012);
            yield return Hit(1, 5.81, "Paper right", -0.018, 0.006);
            yield return Hit(1, 6.13, "Paper right", 0.011, -0.021);
            yield return Miss(0, 8.40, 3.1, 2.0);
            yield return Hit(2, 9.02, "Swinger", 0.03, 0.01);
            yield return Hit(1, 9.30, "Swinger", -0.05, 0.04);
        }

        private ShotEvent Hit(int shooter, double timeS, string target, double x, double y)
        {
            SceneObject thing = Find(target);
            var local = new Vector2D(x, y);
            _perspective.TryProject(thing, timeS, local, out Vector2D screenM);
            ShotEvent e = Shot(shooter, timeS, screenM);
            int zone = Math.Max(0, thing.Target!.ZoneAt(local));
            Vector3D point = thing.PoseAt(timeS).TransformPoint(new Vector3D(x, y, 0));
            e.HasHit = true;
            e.Hit = new ScoredHit
            {
                Target = target,
                Zone = thing.Target.Zones[zone].Name,
                Points = thing.Target.Zones[zone].Points,
                Score = thing.Target.Zones[zone].Points * e.Shot.Dot.Confidence,
                PointM = point,
                LocalPointM = local,
                DistanceM = _perspective.DistanceTo(point) - 2.6,
                ZoneProbability = _id % 5 == 3 ? 0.71 : 0.97,
            };
            return e;
        }

        private ShotEvent Miss(int shooter, double timeS, double x, double y) => Shot(shooter, timeS, new Vector2D(x, y));

        private ShotEvent Shot(int shooter, double timeS, Vector2D screenM)
        {
            ShotEvent e = EventExamples.PlainShot(++_id, StartUs + (long)Math.Round(timeS * 1e6));
            e.Shot.Dot.PositionPx = new Vector2D(150 + screenM.X * 260, 90 + screenM.Y * 240);
            e.Shot.Dot.Color = shooter == 2 ? LaserColor.Red : LaserColor.Green;
            e.Shot.Dot.Confidence = 0.8 + 0.19 * _random.NextDouble();
            e.HasScreenPosition = true;
            e.ScreenM = screenM;
            e.ScreenCovarianceMm2 = new Covariance2D(2 + 2 * _random.NextDouble(), 0.8, 1 + _random.NextDouble());
            e.Shooter = shooter;
            e.ShooterProbability = shooter == 0 ? 0 : 0.98;
            e.Hand = HandSide.Right;
            return e;
        }

        private SceneObject Find(string name)
        {
            foreach (SceneObject thing in Scene.Objects)
            {
                if (thing.Name == name)
                    return thing;
            }

            throw new ArgumentException(name);
        }

        private static SceneObject[] Objects()
        {
            TargetDefinition popper = Popper(), rings = Rings(), silhouette = Silhouette(TargetKind.Silhouette, 1), hostage = Silhouette(TargetKind.NoShoot, -1);
            return new[]
            {
                Scenery("Floor", new Vector3D(0, -1.05, 10), new Vector3D(30, 0.1, 20)),
                Scenery("Wall", new Vector3D(0, 1, 16), new Vector3D(14, 4, 0.2)),
                Target("Popper 1", popper, new Vector3D(-1.5, -0.55, 3)),
                Target("Popper 2", popper, new Vector3D(-0.8, -0.55, 4)),
                Target("Popper 3", popper, new Vector3D(0.1, -0.55, 5)),
                Target("Paper left", rings, new Vector3D(-1.6, 0.7, 2)),
                Target("Paper right", rings, new Vector3D(1.9, 0.6, 2)),
                Target("Silhouette 1", silhouette, new Vector3D(0.7, -0.3, 3)),
                Target("Hostage", hostage, new Vector3D(1.15, -0.4, 4)),
                Target("Runner", silhouette, new Vector3D(-1, -0.2, 7), new MotionPath(MotionKind.PingPong, new Vector3D(4, 0, 0), 8, 0)),
                Target("Swinger", popper, new Vector3D(0, 0.9, 4), new MotionPath(MotionKind.Sine, new Vector3D(0.6, 0, 0), 3, 0)),
            };
        }

        private static SceneObject Target(string name, TargetDefinition definition, Vector3D position, MotionPath motion = default) =>
            new SceneObject(name, 8, new Pose(position, Rotation3D.Identity), new Vector3D(1, 1, 1), Rotation3D.Identity, motion,
                new[] { SceneCollider.Box(default, new Vector3D(definition.SizeM.X, definition.SizeM.Y, 0.02)) }, definition);

        private static SceneObject Scenery(string name, Vector3D position, Vector3D size) =>
            new SceneObject(name, 0, new Pose(position, Rotation3D.Identity), size, Rotation3D.Identity, default,
                new[] { SceneCollider.Box(default, new Vector3D(1, 1, 1)) }, null);

        private static TargetDefinition Popper() => new TargetDefinition("Popper", TargetKind.SteelPopper, new Vector2D(0.3, 0.85), new[]
        {
            new TargetZone("A", 5, ZoneShape.Ellipse, new Vector2D(0, 0), new Vector2D(0.2, 0.2), new Vector2D[0]),
            new TargetZone("steel", 3, ZoneShape.Polygon, default, default, new[]
            {
                new Vector2D(-0.1, -0.42), new Vector2D(0.1, -0.42), new Vector2D(0.15, -0.02), new Vector2D(0.13, 0.08), new Vector2D(0.075, 0.13),
                new Vector2D(0, 0.15), new Vector2D(-0.075, 0.13), new Vector2D(-0.13, 0.08), new Vector2D(-0.15, -0.02),
            }),
        });

        private static TargetDefinition Rings()
        {
            var zones = new TargetZone[10];
            for (int i = 0; i < 10; i++)
                zones[i] = new TargetZone((10 - i).ToString(System.Globalization.CultureInfo.InvariantCulture), 10 - i, ZoneShape.Ellipse, default, new Vector2D(0.05 + 0.05 * i, 0.05 + 0.05 * i), new Vector2D[0]);
            return new TargetDefinition("Rings", TargetKind.RingPaper, new Vector2D(0.5, 0.5), zones);
        }

        private static TargetDefinition Silhouette(TargetKind kind, int sign) => new TargetDefinition("Silhouette", kind, new Vector2D(0.46, 0.76), new[]
        {
            new TargetZone("A", sign > 0 ? 5 : -10, ZoneShape.Rectangle, new Vector2D(0, 0.08), new Vector2D(0.15, 0.28), new Vector2D[0]),
            new TargetZone("C", sign > 0 ? 3 : -10, ZoneShape.Rectangle, new Vector2D(0, 0.04), new Vector2D(0.3, 0.42), new Vector2D[0]),
            new TargetZone("D", sign > 0 ? 1 : -10, ZoneShape.Polygon, default, default, new[]
            {
                new Vector2D(-0.15, -0.38), new Vector2D(0.15, -0.38), new Vector2D(0.23, -0.28), new Vector2D(0.23, 0.16), new Vector2D(0.15, 0.25), new Vector2D(0.08, 0.27),
                new Vector2D(0.08, 0.38), new Vector2D(-0.08, 0.38), new Vector2D(-0.08, 0.27), new Vector2D(-0.15, 0.25), new Vector2D(-0.23, 0.16), new Vector2D(-0.23, -0.28),
            }),
        });
    }
}
