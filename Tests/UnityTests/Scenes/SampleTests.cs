using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
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
            Play(sample, truth.Shots.Last().SceneTimeUs * 1e-6 + 0.3);

            Assert.That(ConsoleLog.Entries.Where(entry => !entry.Message.Contains("of flashes of a")), Is.Empty, "nothing but the advice on which flashes are caught");
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
        public void Samples_EveryOne_IsPlayed()
        {
            IEnumerable<object?> played = GetType().GetMethod(nameof(Sample_Played_ScoresWhatItsScenarioFires))!.GetCustomAttributes(typeof(TestCaseAttribute), false).Select(test => ((TestCaseAttribute)test).Arguments[0]);
            Assert.That(played, Is.EquivalentTo(Directory.GetDirectories(Folder).Select(Path.GetFileName)));
        }

        private static SimulationTruth Truth(string sample) =>
            new SimulatedRange(SimulationScenarioFile.Read(Path.Combine(Folder, sample, sample + ".scenario.json")), UnitySceneReader.Read(SceneOf(sample))).Truth;

        private static string SceneOf(string sample) => Path.Combine(Folder, sample, sample + ".unity");

        private void Play(string sample, double playedS)
        {
            SceneLoader.Load(SceneOf(sample));
            LaserRange range = PlayerLoop.All<LaserRange>().Single();
            range.ShotFired += _shots.Add;
            foreach (LaserTarget target in PlayerLoop.All<LaserTarget>())
                target.Hit += _ => _targetsTold.Add(target.name);
            ShotVisuals visuals = PlayerLoop.All<ShotVisuals>().Single();
            for (int i = 0; i < playedS * 30; i++)
            {
                PlayerLoop.Step(1 / 30.0);
                range.CompleteDueFrames();
                _raysSeen = Math.Max(_raysSeen, visuals.RaysShown);
                _lit.UnionWith(PlayerLoop.All<LaserTarget>().Where(visuals.IsLit).Select(target => target.name));
            }
        }

        private static string Describe(ShotEvent shot) => shot.Shooter + ": " + shot.Hit.Target + " " + shot.Hit.Zone + " " + shot.Hit.Points;

        private static string Describe(TrueShot shot) => shot.Shooter + ": " + shot.Target + " " + shot.Zone + " " + shot.Points;
    }
}
