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
            PlayerArguments parsed = Parse("player.exe", "-batchmode", "-range-scene", "Static", "-screen-width", "1920", "-range-source", "Webcam", "-range-calibration", "a b.json");
            Assert.That((parsed.Scene, parsed.Source, parsed.Calibration), Is.EqualTo(("Static", "Webcam", "a b.json")));
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
            var other = ScriptableObject.CreateInstance<StubSourceAsset>();
            other.name = "other";
            string file = Path.Combine(Path.GetTempPath(), Path.GetRandomFileName());
            File.WriteAllText(file, RangeRig.Calibration);
            try
            {
                Make(rig, other).Apply(Parse("-range-source", "other", "-range-calibration", file));
            }
            finally
            {
                File.Delete(file);
            }

            Assert.That(rig.Range.Source, Is.EqualTo(other));
            Assert.That(rig.Screen.ReadCalibration(), Is.Not.Null);
            Assert.That(ConsoleLog.Entries, Is.Empty);
        }

        [Test]
        public void Setup_WhatIsNotThere_IsSaid()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            PlayerSetup setup = Make(rig, rig.SourceAsset);
            rig.SourceAsset.name = "stub";
            setup.Apply(Parse("-range-source", "nobody", "-range-calibration", "/nowhere/x.json"));
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Message), Has.Some.EqualTo("-range-source nobody: there is no such source; name one of these: stub").And.Some.StartWith("/nowhere/x.json: "));
        }

        [Test]
        public void Setup_OtherScene_IsLoaded()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            Make(rig).Apply(Parse("-range-scene", "Moving Targets"));
            Assert.That(SceneManager.GetActiveScene().name, Is.EqualTo("Moving Targets"));
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
