using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class PlayerSetupTests : StandInTests
    {
        [Test]
        public void Arguments_OfUnityAndOurs_AreToldApart()
        {
            PlayerArguments parsed = Parse("player.exe", "-batchmode", "-range-scene", "Static", "-screen-width", "1920", "-range-source", "Webcam", "-range-hand-source", "Depth", "-range-calibration", "a b.json");
            Assert.That((parsed.Scene, parsed.Source, parsed.HandSource, parsed.Calibration), Is.EqualTo(("Static", "Webcam", "Depth", "a b.json")));
        }

        [TestCase("-range-scene")]
        [TestCase("-range-scene", "-range-source", "x")]
        [TestCase("-range-sorce", "x")]
        public void Arguments_ThatAreNone_AreRefusedWithTheRightOnes(params string[] arguments)
        {
            Assert.That(PlayerArguments.TryParse(arguments, out _, out string problem), Is.False);
            Assert.That(problem, Does.StartWith(arguments[0]).And.EndsWith(PlayerArguments.Usage));
        }

        [Test]
        public void Setup_SourceAndCalibrationNamed_AreUsed()
        {
            var rig = new RangeRig(new StubSource(1, 0), withCalibration: false);
            StubSourceAsset other = ScriptableObject.CreateInstance<StubSourceAsset>(), hands = ScriptableObject.CreateInstance<StubSourceAsset>();
            (other.name, hands.name) = ("other", "hands");
            string file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            File.WriteAllText(file, RangeRig.Calibration);
            try
            {
                Make(rig, other, hands).Apply(Parse("-range-source", "other", "-range-hand-source", "hands", "-range-calibration", file));
            }
            finally
            {
                File.Delete(file);
            }

            Assert.That((rig.Range.Source, rig.Range.HandSource), Is.EqualTo(((FrameSourceAsset)other, (FrameSourceAsset)hands)));
            Assert.That(rig.Screen.ReadCalibration(), Is.Not.Null);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void Setup_WhatIsNotThere_IsSaid()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            PlayerSetup setup = Make(rig, rig.SourceAsset);
            rig.SourceAsset.name = "stub";
            setup.Apply(Parse("-range-source", "nobody", "-range-hand-source", "noone", "-range-calibration", "/nowhere/x.json"));
            rig.Play(0.1);
            setup.Apply(Parse("-range-source", "nobody"));
            rig.Play(0.1);
            Assert.That(rig.Health.Select(health => health.Text), Has.Some.StartsWith("-range-source nobody: there is no such source"));
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Message), Has.Some.StartsWith("-range-hand-source noone: there is no such source"));
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Message), Has.Some.EqualTo("-range-source nobody: there is no such source; name one of these: stub").And.Some.StartWith("/nowhere/x.json: "));
        }

        [Test]
        public void Setup_OtherScene_IsLoaded()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            Make(rig).Apply(Parse("-range-scene", "Moving Targets"));
            Assert.That(SceneManager.GetActiveScene().name, Is.EqualTo("Moving Targets"));
        }

        [TestCase("Assets/Scenes/Range.unity", "Mouse")]
        [TestCase("Assets/Scenes/Range.unity", "RangeSimulation")]
        [TestCase("Packages/com.range.lasertracking/Prefabs/LaserRange.prefab", "Mouse")]
        [TestCase("Packages/com.range.lasertracking/Samples~/MovingTargets/MovingTargets.unity", "Mouse")]
        public void ShippedScene_SourceNamedOnTheCommandLine_Plays(string file, string source)
        {
            RangeRig.AddMainCamera();
            SceneLoader.Load(Path.Combine(TestFiles.Repository, file));
            PlayerSetup setup = PlayerLoop.All<PlayerSetup>().Single();
            setup.Apply(Parse("-range-source", source));
            LaserRange range = setup.GetComponent<LaserRange>();
            PlayerLoop.Step(0.02);
            Assert.That((range.Source!.name, range.IsRunning), Is.EqualTo((source, true)), string.Join("\n", ConsoleLog.Entries));
            setup.Apply(Parse("-range-source", "Kinect"));
            Assert.That(ConsoleLog.Entries.Last().Message, Does.Contain("-range-source Kinect: there is no such source; name one of these: ").And.Contain("Mouse"));
        }

        private static PlayerArguments Parse(params string[] arguments)
        {
            Assert.That(PlayerArguments.TryParse(arguments, out PlayerArguments parsed, out string problem), Is.True, problem);
            return parsed;
        }

        private static PlayerSetup Make(RangeRig rig, params FrameSourceAsset[] sources)
        {
            PlayerSetup setup = rig.Range.gameObject.AddComponent<PlayerSetup>();
            SerializedFields.Set(setup, "_sources", sources);
            return setup;
        }
    }
}
