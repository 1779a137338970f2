using System;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class ScenePoseLogTests
    {
        private string _path = "";

        [SetUp]
        public void MakeFile() => _path = Path.GetTempFileName();

        [TearDown]
        public void RemoveFile() => File.Delete(_path);

        private static SceneModel Scene()
        {
            var zones = new[]
            {
                new TargetZone("in \"quotes\"", 10, ZoneShape.Ellipse, new Vector2D(0.01, -0.02), new Vector2D(0.1, 0.2), new Vector2D[0]),
                new TargetZone("ö", -5, ZoneShape.Polygon, default, default, new[] { new Vector2D(0, 0), new Vector2D(1.0 / 3, 0), new Vector2D(0, Math.PI) }),
            };
            var target = new TargetDefinition("t", TargetKind.SteelPopper, new Vector2D(1, 4), zones);
            var tilt = new Rotation3D(0.1, 0.2, 0.3, 0.9);
            var objects = new[]
            {
                new SceneObject("a", 3, new Pose(new Vector3D(0.1, 1.0 / 3, 7), tilt), new Vector3D(1, 2, 3), tilt, new MotionPath(MotionKind.Sine, new Vector3D(1, 0.5, 0), 4.2, 0.7),
                    new[] { SceneCollider.Box(new Vector3D(0, 0.1, 0), new Vector3D(1, 1, 0.1), true), SceneCollider.Sphere(default, 0.4).OnChild(new Pose(new Vector3D(0, 1, 0), tilt), new Vector3D(1, 1, 2), 8) }, target),
                new SceneObject("b", 8, Pose.Identity, new Vector3D(1, 1, 1), Rotation3D.Identity, default, new[] { SceneCollider.Capsule(default, 0.2, 1.9, 1), SceneCollider.Quad() }, null),
            };
            return new SceneModel("scene", new Pose(new Vector3D(0, 1.63, 0), Rotation3D.Identity), new Vector2D(3.73, 2.26), new Vector3D(0, 1.63, -5), -1, objects);
        }

        private SceneModel Write(SceneModel scene, Action<ScenePoseLog>? log = null)
        {
            using (var writer = new ScenePoseLog(File.Create(_path), scene))
                log?.Invoke(writer);
            return ScenePoseLog.Read(_path);
        }

        private static string Answers(SceneModel scene)
        {
            var caster = new AnalyticRaycaster(scene);
            var random = new Random(1);
            var text = new StringBuilder();
            for (int i = 0; i < 2000; i++)
            {
                var ray = new Ray3D(new Vector3D(0, 1.63, -5), new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, 1));
                bool hits = caster.TryRaycast(ray, 100, random.NextDouble() * 10, out RaycastHit hit);
                text.Append(hits).Append(hit.ObjectIndex).Append(' ').Append(hit.DistanceM.ToString("R")).Append('\n');
            }

            return text.ToString();
        }

        [Test]
        public void Read_WrittenScene_AnswersEveryRayToTheBit()
        {
            foreach (SceneModel scene in new[] { Scene(), SimulationScenes.Default() })
            {
                SceneModel read = Write(scene);
                Assert.That(Answers(read), Is.EqualTo(Answers(scene)));
                Assert.That(Answers(read), Does.Contain("True"));
                Assert.That(read.Objects.Select(o => (o.Name, o.Layer, o.Target?.Name)), Is.EqualTo(scene.Objects.Select(o => (o.Name, o.Layer, o.Target?.Name))));
            }

            TargetZone zone = Write(Scene()).Objects[0].Target!.Zones[1];
            Assert.That((zone.Name, zone.Points, zone.Shape, zone.CornersM[2].Y), Is.EqualTo(("ö", -5, ZoneShape.Polygon, Math.PI)));
        }

        [Test]
        public void Read_LoggedPoses_StandWhereTheHistorySaysTheyDid()
        {
            var history = new PoseHistory(1000);
            var random = new Random(2);
            Pose pose = Pose.Identity;
            SceneModel read = Write(Scene(), log =>
            {
                for (int i = 0; i < 300; i++)
                {
                    // Rests for a while, moves for a while.
                    if (i / 20 % 2 == 1)
                        pose = new Pose(new Vector3D(random.Next(1000) / 8.0, i, 0), new Rotation3D(0, i % 7 / 8.0, 0, 1));
                    history.Add(i / 64.0, pose);
                    log.Add(1, i / 64.0, pose);
                }
            });
            for (double time = -1; time < 6; time += 0.01)
            {
                if (time > 279 / 64.0)
                    break;
                Assert.That(history.TryGetPoseAt(time, out Pose expected), Is.True);
                Pose actual = read.Objects[1].PoseAt(time);
                Assert.That((actual.Position - expected.Position).Length, Is.LessThan(1e-6), "at " + time);
                Assert.That((actual.TransformDirection(new Vector3D(1, 0, 0)) - expected.TransformDirection(new Vector3D(1, 0, 0))).Length, Is.LessThan(1e-6), "at " + time);
            }

            Assert.That(File.ReadLines(_path).Count(), Is.LessThan(200), "poses at rest are not written");
        }

        [Test]
        public void Read_LogCutAnywhere_GivesWhatIsWholeOrOneMessage()
        {
            Write(Scene(), log =>
            {
                for (int i = 0; i < 20; i++)
                    log.Add(0, i, new Pose(new Vector3D(i, 0, 0), Rotation3D.Identity));
            });
            byte[] file = File.ReadAllBytes(_path);
            for (int length = 0; length < file.Length; length += 41)
                Read(file.AsSpan(0, length).ToArray());
            var random = new Random(3);
            for (int i = 0; i < 600; i++)
            {
                byte[] damaged = (byte[])file.Clone();
                for (int change = 0; change <= i % 4; change++)
                    damaged[random.Next(damaged.Length)] = (byte)"0123456789\"{}[],:-eE.tn\n x"[random.Next(26)];
                Read(damaged);
            }

            void Read(byte[] content)
            {
                File.WriteAllBytes(_path, content);
                try
                {
                    ScenePoseLog.Read(_path).Objects[0].PoseAt(3);
                }
                catch (InputException problem)
                {
                    Assert.That(problem.Message, Does.Not.Contain("\n"));
                }
            }
        }

        [Test]
        public void Read_ScreenAndEyeThatMoved_ShotGoesThroughThemAsTheyStood()
        {
            SceneModel scene = Scene(), still = Write(scene, log =>
            {
                for (int i = 0; i < 5; i++)
                {
                    log.Add(ScenePoseLog.Surface, i, scene.Surface);
                    log.Add(ScenePoseLog.Viewpoint, i, new Pose(scene.Viewpoint, Rotation3D.Identity));
                }
            });
            Assert.That(File.ReadAllText(_path).Split('\n'), Has.Length.EqualTo(2), "what stays is not logged");
            SceneModel moved = Write(scene, log =>
            {
                for (int i = 0; i <= 10; i++)
                {
                    var shift = new Vector3D(Math.Max(0, i - 5), 0, 0);
                    log.Add(ScenePoseLog.Surface, i, new Pose(scene.Surface.Position + shift, scene.Surface.Rotation));
                    log.Add(ScenePoseLog.Viewpoint, i, new Pose(scene.Viewpoint + shift, Rotation3D.Identity));
                }
            });
            var middle = new Vector2D(scene.ScreenSizeM.X / 2, scene.ScreenSizeM.Y / 2);
            foreach ((SceneModel model, double timeS, double atM) in new[] { (still, 9.0, 0.0), (moved, 4.0, 0.0), (moved, 7.5, 2.5), (moved, 20.0, 5.0) })
            {
                ScreenView view = model.ViewAt(timeS);
                Assert.That(view.Viewpoint.X - scene.Viewpoint.X, Is.EqualTo(atM).Within(1e-9));
                Assert.That(view.ScreenToScene(new Vector3D(middle.X, middle.Y, 0)).X - scene.Surface.Position.X, Is.EqualTo(atM).Within(1e-9));
            }
        }

        [Test]
        public void Add_Warm_AllocatesNothing()
        {
            using var log = new ScenePoseLog(new MemoryStream(1 << 20), Scene());
            double time = 0;
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 100; i++)
                    log.Add(0, time += 0.01, new Pose(new Vector3D(time, 0, 0), Rotation3D.Identity));
            }), Is.Zero);
        }
    }
}
