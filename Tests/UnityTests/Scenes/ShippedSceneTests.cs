using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
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
using RaycastHit = LaserTracking.Scoring.RaycastHit;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Assets/Scenes/Range.unity, read twice by readers that share no code: into the headless model, and into the stand-in with the
    /// package's components. Both must give the same hits.
    /// </summary>
    public sealed class ShippedSceneTests : StandInTests
    {
        private const double ToleranceM = 2e-3;

        private static readonly string Scene = Path.Combine(TestFiles.Repository, "Assets", "Scenes", "Range.unity");

        [Test]
        public void Scene_Loaded_HasTargetsOfEveryKind()
        {
            SceneLoader.Load(Scene);
            Assert.That(Targets().Where(target => target.Definition == null), Is.Empty);
            Assert.That(Targets(), Has.Count.GreaterThanOrEqualTo(8));
            Assert.That(Targets().Select(target => target.Definition!.Kind).Distinct().Count(), Is.EqualTo(4), "kinds of target");
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void Scene_EveryTarget_IsHitAtItsCenterInBothWorlds()
        {
            SceneLoader.Load(Scene);
            SceneModel model = UnitySceneReader.Read(Scene);
            Assert.That(model.Objects.Where(owner => owner.Target != null).Select(owner => owner.Name), Is.EquivalentTo(Targets().Select(target => target.name)));
            var analytic = new AnalyticRaycaster(model);
            var physics = new PhysicsRaycaster(model.LayerMask);
            foreach (SceneObject target in model.Objects.Where(owner => owner.Target != null))
            {
                foreach (double timeS in new[] { 0, 2.6, 17.1 })
                {
                    Vector3D center = target.PoseAt(timeS).Position;
                    var ray = new Ray3D(model.Viewpoint, center - model.Viewpoint);
                    bool expectsHit = analytic.TryRaycast(ray, 100, timeS, out RaycastHit expected);
                    Assert.That(physics.TryRaycast(ray, 100, timeS, out RaycastHit actual), Is.EqualTo(expectsHit), target.Name);
                    if (expectsHit)
                        Same(physics, actual, analytic, expected, target.Name + " at " + timeS);
                }
            }
        }

        [Test]
        public void Scene_RaysThroughTheScreen_HitTheSameInBothWorlds()
        {
            SceneLoader.Load(Scene);
            SceneModel model = UnitySceneReader.Read(Scene);
            var analytic = new AnalyticRaycaster(model);
            var physics = new PhysicsRaycaster(model.LayerMask);
            var random = new System.Random(23);
            var met = new HashSet<int>();
            int compared = 0;
            foreach (double timeS in new[] { 0, 1.37, 4.9, 33.3 })
            {
                for (int i = 0; i < 250; i++)
                {
                    Vector3D onScreen = model.ScreenToScene(new Vector3D(random.NextDouble() * model.ScreenSizeM.X, random.NextDouble() * model.ScreenSizeM.Y, 0.01));
                    var ray = new Ray3D(onScreen, onScreen - model.Viewpoint);
                    if (!IsClearCut(analytic, ray, timeS, out bool expectsHit, out RaycastHit expected))
                        continue;
                    Assert.That(physics.TryRaycast(ray, 100, timeS, out RaycastHit actual), Is.EqualTo(expectsHit));
                    compared++;
                    if (!expectsHit)
                        continue;
                    met.Add(expected.ObjectIndex);
                    Same(physics, actual, analytic, expected, "ray " + i + " at " + timeS);
                }
            }

            Assert.That(compared, Is.GreaterThan(750));
            Assert.That(met.Count, Is.GreaterThan(8), "different objects met");
        }

        [Test]
        public void Scene_ShotThroughTheCamera_IsScoredAndReachesItsTarget()
        {
            SceneLoader.Load(Scene);
            SceneModel model = UnitySceneReader.Read(Scene);
            SceneObject aimedAt = model.Objects.First(owner => owner.Target != null && owner.Target.Kind != TargetKind.NoShoot && owner.Motion.Kind == MotionKind.None);
            var targetM = new Vector3D(aimedAt.Target!.Zones[0].CenterM.X, aimedAt.Target.Zones[0].CenterM.Y, 0);
            Vector2D dotM = OnScreen(model, aimedAt.PoseAt(0).TransformPoint(targetM));
            LaserTarget target = Targets().Single(candidate => candidate.name == aimedAt.Name);
            int hits = 0;
            target.Hit += shot => hits += shot.Hit.Points == aimedAt.Target.Zones[0].Points ? 1 : 0;

            LaserRange range = World<LaserRange>();
            StubSourceAsset source = ScriptableObject.CreateInstance<StubSourceAsset>();
            source.Create = () => new StubSource(45, 0, (30, (int)Math.Round(dotM.X / 3.73 * 640), (int)Math.Round(dotM.Y / 2.26 * 480)));
            SerializedFields.Set(range, "_source", source);
            SerializedFields.Set(World<ScreenSurface>(), "_calibration", new TextAsset(RangeRig.Calibration));
            Play(range, 120);
            Assert.That(ConsoleLog.Entries, Is.Empty);
            Assert.That(hits, Is.EqualTo(1), aimedAt.Name);
        }

        [Test]
        public void Scene_SimulatedCameras_GiveTheShotsOfTheHeadlessPipeline()
        {
            SceneLoader.Load(Scene);
            var range = new SimulatedRange(Scenario(), UnitySceneReader.Read(Scene));
            StubSourceAsset color = ScriptableObject.CreateInstance<StubSourceAsset>(), depth = ScriptableObject.CreateInstance<StubSourceAsset>();
            color.Create = range.CreateColorSource;
            color.SceneZeroUs = range.Truth.ColorClockUs(0);
            bool isDepthOpened = false;
            depth.Create = () =>
            {
                isDepthOpened = true;
                return range.CreateDepthSource();
            };
            depth.OffsetUs = range.Truth.ColorClockUs(0) - range.Truth.DepthClockUs(0);
            SerializedFields.Set(World<LaserRange>(), "_source", color);
            SerializedFields.Set(World<LaserRange>(), "_handSource", depth);
            SerializedFields.Set(World<ScreenSurface>(), "_calibration", new TextAsset(RangeCalibrationFile.Format(range.Calibration)));
            var shots = new List<ShotEvent>();
            World<LaserRange>().ShotFired += shot => shots.Add(shot);
            var hits = new List<string>();
            foreach (LaserTarget target in Targets())
                target.Hit += _ => hits.Add(target.name);

            // Unity begins late and with a stutter: neither may show in the result.
            PlayerLoop.Step(0.4);
            Play(World<LaserRange>(), 100);
            Assert.That(ConsoleLog.Entries, Is.Empty);
            List<ShotEvent> headless = HeadlessShots(range);
            Assert.That(shots.Select(Describe), Is.EqualTo(headless.Select(Describe)));

            // The engine measures in single precision: rounded to millimetres, equal lengths may differ in the last digit.
            for (int i = 0; i < shots.Count; i++)
            {
                Assert.That(shots[i].Hit.LocalPointM.X, Is.EqualTo(headless[i].Hit.LocalPointM.X).Within(1e-4));
                Assert.That(shots[i].Hit.LocalPointM.Y, Is.EqualTo(headless[i].Hit.LocalPointM.Y).Within(1e-4));
                Assert.That(shots[i].Hit.DistanceM, Is.EqualTo(headless[i].Hit.DistanceM).Within(1e-4));
            }

            string[] moving = range.Scene.Objects.Where(IsMovingTarget).Select(owner => owner.Name).ToArray();
            Assert.That(headless.Count(shot => moving.Contains(shot.Hit.Target)), Is.GreaterThan(0), "a moving target is among them");
            Assert.That(hits, Is.EqualTo(headless.Where(shot => shot.HasHit).Select(shot => shot.Hit.Target)));
            Assert.That(isDepthOpened, Is.True);
        }

        private static bool IsMovingTarget(SceneObject candidate) => candidate.Target != null && candidate.Motion.Kind != MotionKind.None;

        private static List<ShotEvent> HeadlessShots(SimulatedRange range)
        {
            var sink = new EventInbox();
            var settings = new PipelineSettings { SceneTimeZeroUs = range.Truth.ColorClockUs(0) };
            var pipeline = RangePipeline.CreateDefault(new ShotDetector(), range.Calibration, true, new ShotScorer(range.Scene), sink, settings);
            using (IFrameSource color = range.CreateColorSource(), depth = range.CreateDepthSource())
            using (var runner = new SessionRunner(pipeline, color, depth, range.Truth.ColorClockUs(0) - range.Truth.DepthClockUs(0)))
                runner.Run(System.Threading.CancellationToken.None);
            pipeline.End(0);
            var shots = new List<ShotEvent>();
            while (sink.TryTakeShot(out ShotEvent shot))
                shots.Add(shot);
            return shots;
        }

        // To a millimetre: floats and doubles do not agree beyond.
        private static string Describe(ShotEvent shot) => FormattableString.Invariant(
            $"{shot.Shot.Id} {shot.Shot.FirstFrameIndex} {shot.Shot.TimeUs} {shot.ScreenM.X:F6} {shot.ScreenM.Y:F6} by {shot.Shooter} {shot.Hand} {shot.HasMuzzle} hit {shot.Hit.Target} {shot.Hit.Zone} {shot.Hit.Points}");

        private static SimulationScenario Scenario()
        {
            var scenario = new SimulationScenario { Seed = 5, DurationS = 1.35 };
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.ColorCamera.Format = LaserTracking.Imaging.PixelFormat.Nv12;
            scenario.DepthCamera.Binned = true;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shots.Add(new ShotSettings { TimeS = 1.2, PulseMs = 60, Target = "Swinging Ball" });
            scenario.Shots.Add(new ShotSettings { TimeS = 0.6, PulseMs = 60, Target = "Silhouette 2" });
            return scenario;
        }

        private static Vector2D OnScreen(SceneModel model, Vector3D scenePoint)
        {
            Vector3D eye = model.SceneToScreen(model.Viewpoint), point = model.SceneToScreen(scenePoint);
            Vector3D crossing = eye + (point - eye) * (-eye.Z / (point.Z - eye.Z));
            return new Vector2D(crossing.X, crossing.Y);
        }

        private static void Same(PhysicsRaycaster physics, RaycastHit actual, AnalyticRaycaster analytic, RaycastHit expected, string which)
        {
            physics.TryGetTarget(actual.ObjectIndex, out string name, out TargetDefinition? definition);
            analytic.TryGetTarget(expected.ObjectIndex, out string expectedName, out TargetDefinition? expectedDefinition);
            Assert.That(name, Is.EqualTo(expectedName), which);
            Assert.That((actual.PointM - expected.PointM).Length, Is.LessThan(ToleranceM), which);
            Assert.That((actual.LocalPointM - expected.LocalPointM).Length, Is.LessThan(ToleranceM), which);
            Assert.That(Describe(definition), Is.EqualTo(Describe(expectedDefinition)), which);
        }

        // Rounded: Unity stores floats.
        private static string Describe(TargetDefinition? definition) => definition == null ? "scenery"
            : FormattableString.Invariant($"{definition.Name} {definition.Kind} {definition.SizeM.X:F4} {definition.SizeM.Y:F4}: ") + string.Join("; ", definition.Zones.Select(Describe));

        private static string Describe(TargetZone zone) =>
            FormattableString.Invariant($"{zone.Name} {zone.Points} {zone.Shape} {zone.CenterM.X:F4} {zone.CenterM.Y:F4} {zone.SizeM.X:F4} {zone.SizeM.Y:F4} ")
            + string.Join(" ", zone.CornersM.Select(corner => FormattableString.Invariant($"{corner.X:F4},{corner.Y:F4}")));

        private static bool IsClearCut(AnalyticRaycaster analytic, Ray3D ray, double timeS, out bool isHit, out RaycastHit hit)
        {
            isHit = analytic.TryRaycast(ray, 100, timeS, out hit);
            foreach (Vector3D aside in new[] { new Vector3D(3e-4, 0, 0), new Vector3D(-3e-4, 0, 0), new Vector3D(0, 3e-4, 0), new Vector3D(0, -3e-4, 0) })
            {
                if (analytic.TryRaycast(new Ray3D(ray.Origin, ray.Direction + aside), 100, timeS, out RaycastHit near) != isHit
                    || (isHit && (near.ObjectIndex != hit.ObjectIndex || (near.Normal - hit.Normal).Length > 0.1)))
                    return false;
            }

            return true;
        }

        private static void Play(LaserRange range, int frames)
        {
            for (int i = 0; i < frames; i++)
            {
                PlayerLoop.Step(1 / 60.0);
                range.CompleteDueFrames();
            }
        }

        private static List<LaserTarget> Targets() => PlayerLoop.All<LaserTarget>();

        private static T World<T>() where T : Component => PlayerLoop.All<T>().Single();
    }
}
