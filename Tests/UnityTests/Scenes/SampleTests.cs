using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Host.Scenes;
using LaserTracking.Session;
using LaserTracking.Simulation;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>The package's samples as they are imported: press Play, and each fires the shots of its own scenario at its own targets.</summary>
    [FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
    public sealed class SampleTests : StandInTests
    {
        private static readonly string Folder = Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "Samples~");

        private readonly List<ShotEvent> _shots = new List<ShotEvent>();
        private readonly List<string> _targetsTold = new List<string>();
        private readonly HashSet<string> _lit = new HashSet<string>();
        private int _raysSeen;

        [TestCase("StaticRange", 43, 0)]
        [TestCase("MovingTargets", 33, 0)]
        [TestCase("ShootNoShoot", 5, 2)]
        public void Sample_Played_ScoresWhatItsScenarioFires(string sample, int points, int mistakes)
        {
            SimulationTruth truth = Truth(sample);
            Load(sample);
            Play(truth.Shots.Last().SceneTimeUs * 1e-6 + 0.3);

            Assert.That(ConsoleLog.Entries, Is.Empty);
            Assert.That(_shots.Select(Describe), Is.EqualTo(truth.Shots.Select(Describe)));
            string[] expected = truth.Shots.Where(shot => shot.Target != "").Select(shot => shot.Target).ToArray();
            Assert.That(_targetsTold, Is.EqualTo(expected));

            ScoreSheet sheet = PlayerLoop.All<Scoreboard>().Single().Sheet;
            Assert.That((sheet.Total.Shots, sheet.Total.Hits, sheet.Total.Mistakes, sheet.Total.Misses), Is.EqualTo((truth.Shots.Count, expected.Length - mistakes, mistakes, 1)));
            Assert.That(sheet.Total.Points, Is.EqualTo(points));
            Assert.That(sheet.Total.Score, Is.EqualTo(_shots.Sum(shot => shot.Hit.Score)).Within(1e-6));

            ShotVisuals visuals = PlayerLoop.All<ShotVisuals>().Single();
            Assert.That(visuals.HolesShown, Is.EqualTo(_shots.Count), "a shot that misses marks what is behind");
            Assert.That(_raysSeen, Is.GreaterThan(0));
            Assert.That(_lit, Is.EquivalentTo(expected.Distinct()), "targets that flashed");
        }

        [Test]
        public void StaticRange_WithTheMouseForSource_ScoresAClick()
        {
            Load("StaticRange");
            LaserRange range = PlayerLoop.All<LaserRange>().Single();
            range.Source = ScriptableObject.CreateInstance<MouseSource>();
            Wait(() => false, 30);
            LaserTarget target = PlayerLoop.All<LaserTarget>().Single(candidate => candidate.name == "Popper 1");

            // The window's pixel under a point, of a camera that looks along z: its view is 1080 pixels high.
            Camera eye = Camera.main;
            Vector3 aimedAt = eye.transform.InverseTransformPoint(target.transform.TransformPoint(new Vector3(0, 0.38f, 0)));
            double pxPerM = 540 / Math.Tan(eye.fieldOfView * Math.PI / 360) / aimedAt.z;
            Desk.Mouse = new Vector3((float)(960 + aimedAt.x * pxPerM), (float)(540 + aimedAt.y * pxPerM), 0);
            Desk.IsPressed = true;
            PlayerLoop.Step(1 / 60.0);
            Desk.IsPressed = false;
            Wait(() => _shots.Count > 0, 600);
            Assert.That((_shots.Single().Hit.Target, _shots[0].Hit.Zone), Is.EqualTo(("Popper 1", "Circle")));
        }

        [Test]
        public void MovingTargets_FasterRunner_IsMissedBehind()
        {
            using var folder = new TemporaryFolder();
            string scene = Path.Combine(folder.Path, "Faster.unity");
            File.WriteAllText(scene, File.ReadAllText(SceneOf("MovingTargets")).Replace("_periodS: 6\n", "_periodS: 2.5\n", StringComparison.Ordinal));
            LoadScene(scene);
            Play(1.4);
            Assert.That(_shots.Select(shot => shot.HasHit), Is.EqualTo(new[] { true, false }), "its body, its head");
            Assert.That(_targetsTold, Is.EqualTo(new[] { "Runner" }));
        }

        [Test]
        public void Samples_EveryOne_IsPlayed()
        {
            IEnumerable<object?> played = GetType().GetMethod(nameof(Sample_Played_ScoresWhatItsScenarioFires))!.GetCustomAttributes(typeof(TestCaseAttribute), false).Select(test => ((TestCaseAttribute)test).Arguments[0]);
            Assert.That(played, Is.EquivalentTo(Directory.GetDirectories(Folder).Select(Path.GetFileName)));
        }

        private static SimulationTruth Truth(string sample) =>
            new SimulatedRange(SimulationScenarioFile.Read(Path.Combine(Folder, sample, sample + ".scenario.json")), UnitySceneReader.Read(SceneOf(sample))).Truth;

        private static string SceneOf(string sample) => Path.Combine(Folder, sample, sample + ".unity");

        private void Load(string sample) => LoadScene(SceneOf(sample));

        private void LoadScene(string path)
        {
            SceneLoader.Load(path);
            PlayerLoop.All<LaserRange>().Single().ShotFired += _shots.Add;
            foreach (LaserTarget target in PlayerLoop.All<LaserTarget>())
                target.Hit += _ => _targetsTold.Add(target.name);
        }

        private void Play(double playedS)
        {
            LaserRange range = PlayerLoop.All<LaserRange>().Single();
            ShotVisuals visuals = PlayerLoop.All<ShotVisuals>().Single();
            for (int i = 0; i < playedS * 30; i++)
            {
                PlayerLoop.Step(1 / 30.0);
                range.CompleteDueFrames();
                _raysSeen = Math.Max(_raysSeen, visuals.RaysShown);
                _lit.UnionWith(PlayerLoop.All<LaserTarget>().Where(visuals.IsLit).Select(target => target.name));
            }
        }

        private static void Wait(Func<bool> isSo, int frames)
        {
            for (int i = 0; i < frames && !isSo(); i++)
            {
                PlayerLoop.Step(1 / 60.0);
                Thread.Sleep(2);
            }
        }

        private static string Describe(ShotEvent shot) => shot.Shooter + ": " + shot.Hit.Target + " " + shot.Hit.Zone + " " + shot.Hit.Points;

        private static string Describe(TrueShot shot) => shot.Shooter + ": " + shot.Target + " " + shot.Zone + " " + shot.Points;
    }
}
