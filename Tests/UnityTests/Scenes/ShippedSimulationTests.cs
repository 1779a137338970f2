using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scenes;
using LaserTracking.Pipeline;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Simulation;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>Assets/Scenes/Range.unity as it is shipped: press Play, and simulated trainees fire at its targets.</summary>
    public sealed class ShippedSimulationTests : StandInTests
    {
        private const double PlayedS = 4.2;
        private const double FloatM = 1e-5;

        private static readonly string Scene = Path.Combine(TestFiles.Repository, "Assets", "Scenes", "Range.unity");

        [Test]
        public void Scene_Played_FiresTheShotsOfTheHeadlessSession()
        {
            SceneLoader.Load(Scene);
            var shots = new List<ShotEvent>();
            LaserRange range = PlayerLoop.All<LaserRange>().Single();
            range.ShotFired += shot => shots.Add(shot);
            int dots = 0, hands = 0;
            range.DotMoved += _ => dots++;
            range.HandMoved += _ => hands++;
            var hits = new List<string>();
            foreach (LaserTarget target in PlayerLoop.All<LaserTarget>())
                target.Hit += _ => hits.Add(target.name);

            for (int i = 0; i < PlayedS * 60; i++)
            {
                PlayerLoop.Step(1 / 60.0);
                range.CompleteDueFrames();
            }

            Assert.That(ConsoleLog.Entries, Is.Empty);
            Assert.That(range.IsRunning, Is.True);
            PlayerLoop.Step(1 / 60.0);
            ShotVisuals visuals = PlayerLoop.All<ShotVisuals>().Single();
            ScoreSheet sheet = PlayerLoop.All<Scoreboard>().Single().Sheet;
            Assert.That(visuals.HolesShown, Is.EqualTo(shots.Count), "every shot leaves a mark: on a target or on what is behind");
            Assert.That((sheet.Total.Shots, sheet.Total.Hits + sheet.Total.Mistakes), Is.EqualTo((shots.Count, hits.Count)));
            Assert.That(sheet.Shooters.Select(row => row.Number).Where(number => number > 0).Count(), Is.GreaterThanOrEqualTo(2));
            range.gameObject.SetActive(false);
            Assert.That((visuals.HolesShown, visuals.RaysShown), Is.EqualTo((0, 0)));

            List<ShotEvent> headless = HeadlessShots(out SimulationTruth truth);
            Assert.That(shots.Select(Describe), Is.EqualTo(headless.Select(Describe)));
            for (int i = 0; i < shots.Count; i++)
            {
                Assert.That((shots[i].ScreenM - headless[i].ScreenM).Length, Is.LessThan(1e-3), "shot " + i);
                Assert.That((shots[i].Hit.LocalPointM - headless[i].Hit.LocalPointM).Length, Is.LessThan(5e-3), "shot " + i);
            }

            Assert.That(hits, Is.EqualTo(shots.Where(shot => shot.HasHit).Select(shot => shot.Hit.Target)));
            Assert.That(dots, Is.GreaterThanOrEqualTo(shots.Count));
            Assert.That(hands, Is.GreaterThan(100), "three shooters' hands in a hundred frames");
            Assert.That(shots.Count(shot => shot.HasMuzzle), Is.GreaterThan(0), "camera 1 plays too");
            string[] aimedAt = truth.Shots.Where(shot => shot.SceneTimeUs < 3.9e6).Select(shot => shot.AimedAt).ToArray();
            Assert.That(aimedAt, Has.Length.EqualTo(6), "what the scenario fires until then");
            Assert.That(hits, Is.EqualTo(aimedAt));
        }

        [Test]
        public void Scene_SwitchedOffAndOn_BeginsAnew()
        {
            SceneLoader.Load(Scene);
            LaserRange range = PlayerLoop.All<LaserRange>().Single();
            PlayerLoop.Step(0.1);
            Assert.That(range.IsRunning, Is.True);
            range.enabled = false;
            Assert.That(range.IsRunning, Is.False);
            PlayerLoop.Step(1.5);
            range.enabled = true;
            PlayerLoop.Step(0.1);
            Assert.That(range.IsRunning, Is.True);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void SceneModelBuilder_ShippedSceneInMotion_IsWhatTheHeadlessReaderReads()
        {
            SceneLoader.Load(Scene);
            for (int i = 0; i < 20; i++)
                PlayerLoop.Step(0.05);
            SceneModel expected = UnitySceneReader.Read(Scene);
            Vector3[] shown = PlayerLoop.All<Transform>().Select(transform => transform.position).ToArray();
            SceneModel actual = SceneModelBuilder.Build(PlayerLoop.All<LaserRange>().Single());
            Assert.That(PlayerLoop.All<Transform>().Select(transform => transform.position), Is.EqualTo(shown), "nothing stays moved");

            Same(actual.Surface, expected.Surface, "screen");
            Assert.That((actual.ScreenSizeM - expected.ScreenSizeM).Length, Is.LessThan(1e-6));
            Same(actual.Viewpoint, expected.Viewpoint, "viewpoint");
            Assert.That(actual.LayerMask, Is.EqualTo(expected.LayerMask));
            Assert.That(actual.Objects.Select(item => item.Name), Is.EqualTo(expected.Objects.Select(item => item.Name)));
            for (int i = 0; i < expected.Objects.Count; i++)
                Same(actual.Objects[i], expected.Objects[i]);
            Assert.That(expected.Objects.SelectMany(item => item.Colliders).Select(collider => collider.Shape).Distinct().Count(), Is.EqualTo(4), "every shape is among them");
        }

        private static List<ShotEvent> HeadlessShots(out SimulationTruth truth)
        {
            SimulationScenario scenario = SimulationScenarioFile.Read(Path.Combine(TestFiles.Repository, "Assets", "Sources", "demo.scenario.json"));
            var range = new SimulatedRange(scenario, UnitySceneReader.Read(Scene));
            truth = range.Truth;
            var sink = new EventInbox();
            long zeroUs = range.Truth.ColorClockUs(0);
            var pipeline = RangePipeline.CreateDefault(new ShotDetector(), range.Calibration, true, new ShotScorer(range.Scene), sink, new PipelineSettings { SceneTimeZeroUs = zeroUs });
            using (var stop = new CancellationTokenSource())
            using (IFrameSource color = new PrefetchingFrameSource(range.CreateColorSource()), depth = new PrefetchingFrameSource(range.CreateDepthSource()))
            using (var runner = new SessionRunner(pipeline, color, depth, zeroUs - range.Truth.DepthClockUs(0)))
            {
                runner.BeforeFrame = frame =>
                {
                    if (frame.TimeUs - zeroUs > PlayedS * 1e6)
                        stop.Cancel();
                };
                runner.Run(stop.Token);
            }

            pipeline.End(0);
            var shots = new List<ShotEvent>();
            while (sink.TryTakeShot(out ShotEvent shot))
                shots.Add(shot);
            return shots;
        }

        private static string Describe(ShotEvent shot) => FormattableString.Invariant(
            $"{shot.Shot.FirstFrameIndex} by {shot.Shooter} {shot.Hand} hit {shot.Hit.Target} {shot.Hit.Zone} {shot.Hit.Points}");

        private static void Same(SceneObject actual, SceneObject expected)
        {
            string name = expected.Name;
            Assert.That(actual.Layer, Is.EqualTo(expected.Layer), name);
            Same(actual.RestPose, expected.RestPose, name);
            Same(actual.Scale, expected.Scale, name);
            Assert.That(actual.Motion.Kind, Is.EqualTo(expected.Motion.Kind), name);
            foreach (double timeS in new[] { 0, 1.3, 7.7, 20 })
                Same(actual.PoseAt(timeS), expected.PoseAt(timeS), name);
            Assert.That(actual.Colliders.Count, Is.EqualTo(expected.Colliders.Count), name);
            for (int i = 0; i < expected.Colliders.Count; i++)
                Same(actual.Colliders[i], expected.Colliders[i], name);
            Same(actual.Target, expected.Target, name);
        }

        private static void Same(SceneCollider actual, SceneCollider expected, string name)
        {
            Assert.That((actual.Shape, actual.Axis, actual.IsTrigger, actual.IsOnChild, actual.ChildLayer), Is.EqualTo((expected.Shape, expected.Axis, expected.IsTrigger, expected.IsOnChild, expected.ChildLayer)), name);
            Same(actual.Center, expected.Center, name);
            Same(actual.Size, expected.Size, name);
            Assert.That(actual.Radius, Is.EqualTo(expected.Radius).Within(FloatM), name);
            Assert.That(actual.Height, Is.EqualTo(expected.Height).Within(FloatM), name);
            if (!expected.IsOnChild)
                return;
            Same(actual.ChildPose, expected.ChildPose, name);
            Same(actual.ChildScale, expected.ChildScale, name);
        }

        private static void Same(TargetDefinition? actual, TargetDefinition? expected, string name)
        {
            Assert.That(actual == null, Is.EqualTo(expected == null), name);
            if (actual == null || expected == null)
                return;
            Assert.That((actual.Name, actual.Kind, actual.Zones.Count), Is.EqualTo((expected.Name, expected.Kind, expected.Zones.Count)), name);
            Assert.That((actual.SizeM - expected.SizeM).Length, Is.LessThan(1e-6), name);
            for (int i = 0; i < expected.Zones.Count; i++)
            {
                TargetZone zone = actual.Zones[i], wanted = expected.Zones[i];
                Assert.That((zone.Name, zone.Points, zone.Shape, zone.CornersM.Count), Is.EqualTo((wanted.Name, wanted.Points, wanted.Shape, wanted.CornersM.Count)), name);
                Assert.That((zone.CenterM - wanted.CenterM).Length + (zone.SizeM - wanted.SizeM).Length, Is.LessThan(1e-6), name);
                for (int corner = 0; corner < wanted.CornersM.Count; corner++)
                    Assert.That((zone.CornersM[corner] - wanted.CornersM[corner]).Length, Is.LessThan(1e-6), name);
            }
        }

        // Three points tell position and rotation, whatever the quaternion's sign.
        private static void Same(Pose actual, Pose expected, string name)
        {
            foreach (var point in new[] { default, new Vector3D(1, 0, 0), new Vector3D(0, 1, 0) })
                Same(actual.TransformPoint(point), expected.TransformPoint(point), name);
        }

        private static void Same(Vector3D actual, Vector3D expected, string name) => Assert.That((actual - expected).Length, Is.LessThan(FloatM), name);
    }
}
