using System;
using System.IO;
using LaserTracking.Geometry;
using LaserTracking.Host.Scenes;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class ExplainCommandTests
    {
        /// <summary>The first frame that shows the only shot.</summary>
        private const int ShotFrame = 15;

        [Test]
        public void Explain_FrameOfAShot_DrawsItAndListsItsTests()
        {
            using var folder = new TemporaryFolder();
            string picture = folder.File("frame.png");
            (int exitCode, string output, string error) = CommandLine.Run("explain", Scenario(folder), "--frame", Text(ShotFrame), "--out", picture);
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(output, Does.Contain("frame 15 of ").And.Contain("1 shot"));
            Assert.That(output, Does.Contain("ok   rise, levels").And.Contain("shot 1, green, reported in this frame"));
            AssertPng(picture);
        }

        [Test]
        public void Explain_PlaceOfAShot_ShowsItAlone()
        {
            using var folder = new TemporaryFolder();
            string scenario = Scenario(folder), picture = folder.File("at.png");
            Vector2D at = new SimulatedRange(SimulationScenarioFile.Read(scenario), UnitySceneReader.Read(Path.Combine(TestFiles.Repository, "Assets", "Scenes", "Range.unity"))).Truth.Shots[0].FirstLightPx;
            (int exitCode, string output, string error) = CommandLine.Run("explain", scenario, "--frame", Text(ShotFrame), "--at", FormattableString.Invariant($"{at.X:F1},{at.Y:F1}"), "--out", picture);
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(output.Split("\n#").Length - 1, Is.EqualTo(1), output);
            Assert.That(output, Does.Contain("shot 1"));
            AssertPng(picture);
        }

        [Test]
        public void Explain_PlaceWhereNothingIs_SaysWhy()
        {
            using var folder = new TemporaryFolder();
            (int exitCode, string output, string error) = CommandLine.Run("explain", Scenario(folder), "--frame", Text(ShotFrame), "--at", "3,3", "--out", folder.File("no.png"));
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(output, Does.Contain("no candidate at 3, 3").And.Contain("its tile rose by").And.Contain("the nearest candidate is #"));
        }

        [Test]
        public void Explain_FirstFrame_SaysThatNothingWasSearched()
        {
            using var folder = new TemporaryFolder();
            (_, string output, _) = CommandLine.Run("explain", Scenario(folder), "--frame", "0", "--at", "3,3", "--out", folder.File("no.png"));
            Assert.That(output, Does.Contain("nothing was searched in this frame"));
        }

        [Test]
        public void Explain_AnotherDetector_ListsWhatItSays()
        {
            using var folder = new TemporaryFolder();
            (int exitCode, string output, string error) = CommandLine.Run("explain", Scenario(folder), "--frame", Text(ShotFrame), "--detector", "paper", "--out", folder.File("paper.png"));
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(output, Does.Contain("detector paper"));
            AssertPng(folder.File("paper.png"));
        }

        [Test]
        public void Explain_WhatIsNotThere_IsRefusedWithoutAPicture()
        {
            using var folder = new TemporaryFolder();
            string scenario = Scenario(folder), picture = folder.File("no.png");
            CommandLine.AssertRefused("has no frame 5000", "explain", scenario, "--frame", "5000", "--out", picture);
            CommandLine.AssertRefused("-2 is no frame", "explain", scenario, "--frame", "-2", "--out", picture);
            CommandLine.AssertRefused("lies outside the picture", "explain", scenario, "--frame", "3", "--at", "320,10", "--out", picture);
            CommandLine.AssertRefused("two numbers", "explain", scenario, "--frame", "3", "--at", "here", "--out", picture);
            CommandLine.AssertRefused("no detector", "explain", scenario, "--frame", "3", "--detector", "magic", "--out", picture);
            CommandLine.AssertRefused("exist", "explain", folder.File("none.mp4"), "--frame", "3", "--out", picture);
            CommandLine.AssertRefused("also read", "explain", scenario, "--frame", "3", "--out", scenario);
            Assert.That(File.Exists(picture), Is.False);
        }

        private static string Scenario(TemporaryFolder folder)
        {
            var scenario = new SimulationScenario { DurationS = 1 };
            (scenario.ColorCamera.Width, scenario.ColorCamera.Height) = (320, 180);
            (scenario.Projector.Width, scenario.Projector.Height) = (320, 180);
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shots.Add(new ShotSettings { TimeS = 0.5, PulseMs = 80, ScreenM = new Vector2D(1.2, 0.3) });
            string path = folder.File("small.scenario.json");
            File.WriteAllText(path, SimulationScenarioFile.ToJson(scenario));
            return path;
        }

        private static string Text(int number) => number.ToString(System.Globalization.CultureInfo.InvariantCulture);

        private static void AssertPng(string path)
        {
            byte[] bytes = File.ReadAllBytes(path);
            Assert.That(bytes.AsSpan(0, 4).ToArray(), Is.EqualTo(new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G' }));
            Assert.That(bytes.Length, Is.GreaterThan(5000));
        }
    }
}
