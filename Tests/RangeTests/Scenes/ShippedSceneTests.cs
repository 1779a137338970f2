using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Scenes;
using LaserTracking.Scoring;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Scenes
{
    /// <summary>Assets/Scenes/Range.unity as a trainer gets it.</summary>
    public sealed class ShippedSceneTests
    {
        private static readonly double[] Times = { 0, 0.8, 2.35, 5.1, 13.7, 61.3 };
        private static readonly SceneModel Scene = UnitySceneReader.Read(ScenePath);

        private static string ScenePath => Path.Combine(TestFiles.Repository, "Assets", "Scenes", "Range.unity");

        private static IEnumerable<SceneObject> Targets => Scene.Objects.Where(candidate => candidate.Target != null);

        [Test]
        public void ShippedScene_Targets_AreOfFourKindsAndSomeMove()
        {
            Assert.That(Targets.Count(), Is.GreaterThanOrEqualTo(10));
            Assert.That(Targets.Select(target => target.Target!.Kind).Distinct().Count(), Is.EqualTo(4));
            Assert.That(Targets.Count(target => target.Motion.Kind != MotionKind.None), Is.GreaterThanOrEqualTo(4));
            Assert.That(Targets.Select(target => target.Motion.Kind).Distinct().Count(), Is.EqualTo(4));
            Assert.That(Targets.SelectMany(target => target.Colliders).Select(collider => collider.Shape).Distinct(),
                Is.EquivalentTo(new[] { ColliderShape.Box, ColliderShape.Sphere, ColliderShape.Capsule }));
            Assert.That(Scene.Objects.SelectMany(scenery => scenery.Colliders).Any(collider => collider.Shape == ColliderShape.Quad), Is.True);
        }

        [Test]
        public void ShippedScene_Screen_IsThePublishedOneSeenFromFiveMetres()
        {
            Assert.That(Scene.ScreenSizeM, Is.EqualTo(new Vector2D(3.73, 2.26)));
            Vector3D eye = Scene.SceneToScreen(Scene.Viewpoint);
            Assert.That(eye.X, Is.EqualTo(3.73 / 2).Within(1e-9));
            Assert.That(eye.Y, Is.EqualTo(2.26 / 2).Within(1e-9));
            Assert.That(eye.Z, Is.EqualTo(-5).Within(1e-9));
            Assert.That(Scene.LayerMask, Is.EqualTo(1 << 0 | 1 << 8));
            Assert.That(Targets.All(target => target.Layer == 8), Is.True);
        }

        [Test]
        public void ShippedScene_Targets_StandFiveToTwentyFiveMetresBehindTheScreen()
        {
            foreach (SceneObject target in Targets)
                Assert.That(Scene.SceneToScreen(target.RestPose.Position).Z, Is.InRange(5, 25), target.Name);
        }

        [Test]
        public void ShippedScene_Targets_StayWhollyInThePictureOverTheirWholePath()
        {
            foreach (SceneObject target in Targets)
            {
                for (double time = 0; time < 40; time += 0.1)
                {
                    for (int corner = 0; corner < 4; corner++)
                    {
                        var local = new Vector3D((corner % 2 - 0.5) * target.Target!.SizeM.X, (corner / 2 - 0.5) * target.Target.SizeM.Y, 0);
                        Vector2D dot = Dot(target.PoseAt(time).TransformPoint(local));
                        Assert.That(dot.X, Is.InRange(0.05, 3.68), target.Name);
                        Assert.That(dot.Y, Is.InRange(0.05, 2.21), target.Name);
                    }
                }
            }
        }

        [Test]
        public void ShippedScene_RayToEachTargetsCentre_HitsItUnlessAnotherStandsInFront()
        {
            var raycaster = new AnalyticRaycaster(Scene);
            int clear = 0, covered = 0;
            foreach (double time in Times)
            {
                for (int i = 0; i < Scene.Objects.Count; i++)
                {
                    SceneObject target = Scene.Objects[i];
                    if (target.Target == null)
                        continue;
                    Vector3D toTarget = target.PoseAt(time).Position - Scene.Viewpoint;
                    Assert.That(raycaster.TryRaycast(new Ray3D(Scene.Viewpoint, toTarget), 100, time, out RaycastHit hit), Is.True, target.Name);
                    if (hit.ObjectIndex == i)
                    {
                        clear++;
                        double depth = target.Colliders.Max(collider => Math.Max(collider.Radius * target.Scale.X, collider.Size.Z));
                        double oblique = depth / toTarget.Normalized.Z;
                        Assert.That(hit.DistanceM, Is.EqualTo(toTarget.Length).Within(oblique + 1e-9), target.Name);
                    }
                    else
                    {
                        covered++;
                        Assert.That(hit.DistanceM, Is.LessThan(toTarget.Length), target.Name + " behind " + Scene.Objects[hit.ObjectIndex].Name);
                    }
                }
            }

            Assert.That(clear, Is.GreaterThan(20 * covered), "most targets are free most of the time");
        }

        [Test]
        public void ShippedScene_EveryZoneOfEveryDefinition_CanBeHit()
        {
            var met = new HashSet<(string, string)>();
            var scorer = new ShotScorer(Scene);
            for (int y = 0; y < 452; y++)
            {
                for (int x = 0; x < 746; x++)
                {
                    if (scorer.TryScore(new Vector2D((x + 0.5) * 0.005, (y + 0.5) * 0.005), default, 1, null, 0, out ScoredHit hit))
                        met.Add((Definition(hit.Target), hit.Zone));
                }
            }

            foreach (TargetDefinition definition in Targets.Select(target => target.Target!).Distinct())
            {
                foreach (TargetZone zone in definition.Zones)
                {
                    bool tooSmallForThisGrid = zone.Shape == ZoneShape.Ellipse && zone.SizeM.X < 0.06;
                    Assert.That(tooSmallForThisGrid || met.Contains((definition.Name, zone.Name)), Is.True, definition.Name + " " + zone.Name);
                }
            }
        }

        [Test]
        public void ShippedScene_Runner_IsHitAtThePlaceOfItsPhotonTime()
        {
            SceneObject runner = Targets.Single(target => target.Name == "Runner");
            var scorer = new ShotScorer(Scene);
            Vector2D dot = Dot(runner.PoseAt(1.5).Position);
            Assert.That(scorer.TryScore(dot, default, 1, null, 1.5, out ScoredHit hit), Is.True);
            Assert.That(hit.Target, Is.EqualTo("Runner"));
            Assert.That(hit.LocalPointM.Length, Is.LessThan(0.01));
            bool later = scorer.TryScore(dot, default, 1, null, 2.5, out hit);
            Assert.That(later && hit.Target == "Runner", Is.False);
        }

        [TestCase("RingsPrecision", "10", 0.05)]
        [TestCase("RingsPrecision", "7", 0.2)]
        [TestCase("RingsPrecision", "1", 0.5)]
        [TestCase("RingsPrecision", "X", 0.025)]
        [TestCase("RingsB8", "X", 0.0431)]
        [TestCase("RingsB8", "9", 0.1407)]
        [TestCase("RingsB8", "5", 0.4999)]
        [TestCase("Plate", "Plate", 0.2032)]
        public void ShippedDefinition_Ring_HasThePublishedDiameter(string definition, string zone, double diameterM)
        {
            TargetZone found = Read(definition).Zones.Single(candidate => candidate.Name == zone);
            Assert.That(found.SizeM, Is.EqualTo(new Vector2D(diameterM, diameterM)));
        }

        [Test]
        public void ShippedDefinition_Zones_LieInTheirCardMostValuableFirst()
        {
            foreach (string file in Directory.EnumerateFiles(Path.Combine(TestFiles.Repository, "Assets", "Targets"), "*.asset"))
            {
                TargetDefinition definition = TargetDefinitionReader.ReadFile(file);
                Assert.That(definition.Name, Is.EqualTo(Path.GetFileNameWithoutExtension(file)));
                int[] points = definition.Zones.Select(zone => zone.Points).ToArray();
                Assert.That(points, Is.Ordered.Descending, definition.Name);
                Assert.That(points.All(value => value < 0), Is.EqualTo(definition.Kind == TargetKind.NoShoot), definition.Name);
                for (double x = -1; x <= 1; x += 0.01)
                {
                    for (double y = -1; y <= 1; y += 0.01)
                    {
                        if (definition.ZoneAt(new Vector2D(x, y)) >= 0)
                        {
                            Assert.That(Math.Abs(x), Is.LessThanOrEqualTo(definition.SizeM.X / 2 + 1e-6), definition.Name);
                            Assert.That(Math.Abs(y), Is.LessThanOrEqualTo(definition.SizeM.Y / 2 + 1e-6), definition.Name);
                        }
                    }
                }
            }
        }

        private static TargetDefinition Read(string name) =>
            TargetDefinitionReader.ReadFile(Path.Combine(TestFiles.Repository, "Assets", "Targets", name + ".asset"));

        private static string Definition(string target) => Targets.Single(candidate => candidate.Name == target).Target!.Name;

        private static Vector2D Dot(Vector3D scenePoint)
        {
            Vector3D point = Scene.SceneToScreen(scenePoint), eye = Scene.SceneToScreen(Scene.Viewpoint);
            double u = -eye.Z / (point.Z - eye.Z);
            return new Vector2D(eye.X + (point.X - eye.X) * u, eye.Y + (point.Y - eye.Y) * u);
        }
    }
}
