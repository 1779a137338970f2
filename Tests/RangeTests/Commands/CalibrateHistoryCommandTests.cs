using System;
using System.IO;
using System.Linq;
using LaserTracking.Host;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class CalibrateHistoryCommandTests
    {
        [Test]
        public void History_ThreeSessions_ShowsTrendAndBest()
        {
            using var folder = new TemporaryFolder();
            string history = folder.File("history");
            foreach ((string date, string noise) in new[] { ("2026-03-01", "0.3"), ("2026-01-01", "0.1"), ("2026-02-01", "0.2") })
                Calibrate(folder, noise, "--date", date, "--history", history, "--replace");
            Calibrate(folder, "0.2", "--date", "2026-02-01", "--history", history, "--replace");
            (int exitCode, string output, _) = CommandLine.Run("calibrate", "history", history);
            string[] lines = output.Split('\n');
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(lines.Where(line => line.StartsWith("2026")).Select(line => line.Split(' ', System.StringSplitOptions.RemoveEmptyEntries)[1]),
                Is.EqualTo(new[] { "2026-01-01-camera.json", "2026-02-01-camera-2.json", "2026-02-01-camera.json", "2026-03-01-camera.json" }));
            Assert.That(lines.Single(line => line.TrimEnd().EndsWith('*')), Does.StartWith("2026-01-01"));
            Assert.That(output, Does.Contain("best: 2026-01-01-camera.json").And.Contain("trend: getting worse"));
            JArray tables = JArray.Parse(CommandLine.Run("calibrate", "history", history, "--json").Output);
            Assert.That(tables[0]["rows"]!, Has.Count.EqualTo(4));
        }

        [Test]
        public void Board_WorseThanWhatIsThere_StaysOutUnlessToldTo()
        {
            using var folder = new TemporaryFolder();
            string camera = Calibrate(folder, "0.1");
            byte[] better = File.ReadAllBytes(camera);
            (int exitCode, _, string error) = Run(folder, "0.4");
            Assert.That(exitCode, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("what is there is better").And.Contain("--replace"));
            Assert.That(File.ReadAllBytes(camera), Is.EqualTo(better));
            Calibrate(folder, "0.4", "--replace");
            Assert.That(File.ReadAllBytes(camera), Is.Not.EqualTo(better));
            Calibrate(folder, "0.1");
            Assert.That(File.ReadAllBytes(camera), Is.EqualTo(better));
        }

        [Test]
        public void Screen_WorseOrUnproven_StaysOutUnlessToldTo()
        {
            using var folder = new TemporaryFolder();
            string screen = folder.File("screen.json"), points = folder.File("points.json"), corners = "\"image_px\":[[0,0],[600,0],[600,400],[0,400]],\"screen_m\":[[0,0],[3,0],[3,2],[0,2]]";
            (int, string) Screen(double offM, params string[] more)
            {
                File.WriteAllText(points, FormattableString.Invariant($"{{{corners},\"verify\":{{\"image_px\":[[300,200]],\"screen_m\":[[{1.5 + offM},1]]}}}}"));
                (int code, _, string error) = CommandLine.Run(["calibrate", "screen", "--size", "3x2", "--points", points, "--out", screen, .. more]);
                return (code, error);
            }

            Assert.That(Screen(0.001).Item1, Is.EqualTo(ExitCodes.Done));
            byte[] better = File.ReadAllBytes(screen);
            (int worse, string said) = Screen(0.002);
            Assert.That(worse, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(said, Does.Contain("1.000 mm on held-out points, the new one 2.000 mm").And.Contain("--replace"));
            (int unproven, _, said) = CommandLine.Run("calibrate", "screen", "--size", "3x2", "--out", screen, "--corners", "0,0", "600,0", "600,400", "0,400");
            Assert.That(unproven, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(said, Does.Contain("unproven"));
            Assert.That(File.ReadAllBytes(screen), Is.EqualTo(better));
            Assert.That(Screen(0.002, "--replace").Item1, Is.EqualTo(ExitCodes.Done));
            Assert.That(Screen(0.001).Item1, Is.EqualTo(ExitCodes.Done));
        }

        [TestCase("my notes", "no calibration that this can judge")]
        [TestCase("{\"v\":9,\"kind\":\"screen\"}", "newer release")]
        [TestCase("{\"v\":1,\"kind\":\"camera\",\"image_size\":[1280,720]}", "of another camera")]
        [TestCase("{\"v\":1,\"kind\":\"screen\",\"image_size\":[10,10]}", "of another camera")]
        public void Screen_OtherFileInItsPlace_IsNotOverwritten(string content, string words)
        {
            using var folder = new TemporaryFolder();
            string screen = folder.File("screen.json");
            string[] line = ["calibrate", "screen", "--size", "3x2", "--out", screen, "--corners", "0,0", "600,0", "600,400", "0,400"];
            File.WriteAllText(screen, content);
            (int exitCode, _, string error) = CommandLine.Run(line);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain(words).And.Contain("--replace"));
            Assert.That(File.ReadAllText(screen), Is.EqualTo(content));
            Assert.That(CommandLine.Run([.. line, "--replace"]).ExitCode, Is.EqualTo(ExitCodes.Done));
        }

        [Test]
        public void Board_OtherFileInItsPlace_IsNotOverwritten()
        {
            using var folder = new TemporaryFolder();
            string camera = folder.File("camera.json");
            foreach ((string content, string words) in new[] { ("my notes", "no calibration that this can judge"), ("{\"v\":9,\"kind\":\"camera\"}", "newer release"), ("{\"v\":1,\"kind\":\"camera\",\"image_size\":[10,10]}", "of another camera") })
            {
                File.WriteAllText(camera, content);
                (int exitCode, _, string error) = Run(folder, "0.1");
                Assert.That(exitCode, Is.EqualTo(ExitCodes.CheckFailed));
                Assert.That(error, Does.Contain(words));
                Assert.That(File.ReadAllText(camera), Is.EqualTo(content));
            }
        }

        [Test]
        public void History_WhatIsNoCalibration_IsNamedAndTheRestShown()
        {
            using var folder = new TemporaryFolder();
            string history = folder.File("history");
            CommandLine.AssertRefused("no such folder", "calibrate", "history", history);
            Directory.CreateDirectory(history);
            Assert.That(Run(folder, "0.1", "--date", "2026-01-01", "--history", history, "--out", folder.Path).ExitCode, Is.EqualTo(ExitCodes.BadInput));
            CommandLine.AssertRefused("holds no calibration", "calibrate", "history", history);
            Calibrate(folder, "0.1", "--date", "2026-01-01", "--history", history);
            File.WriteAllText(Path.Combine(history, "future.json"), "{\"v\":2,\"kind\":\"camera\"}");
            File.WriteAllText(Path.Combine(history, "screen.json"), "{\"v\":1,\"kind\":\"screen\",\"date\":\"2026-01-02\",\"rms_px\":0.4,\"verify\":{\"n\":9,\"p95_mm\":2.5}}");
            (int exitCode, string output, string error) = CommandLine.Run("calibrate", "history", history);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(error, Does.Contain("future.json").And.Contain("newer release"));
            Assert.That(output, Does.Contain("held_out_mm").And.Contain("best: screen.json, 2.5000 mm"));
        }

        [TestCase("\"rms_px\":-5", "field rms_px is no error")]
        [TestCase("\"rms_px\":NaN", "field rms_px is no error")]
        [TestCase("\"rms_px\":1e400", "field rms_px is no error")]
        [TestCase("\"rms_px\":\"0.1\"", "field rms_px is no error")]
        [TestCase("\"held_out\":{\"rms_px\":99999999999999999999999}", "field held_out.rms_px is no error")]
        [TestCase("\"date\":\"yesterday\"", "field date is no date")]
        [TestCase("\"date\":\"2026-99-99\"", "field date is no date")]
        [TestCase("\"v\":7", "newer release (version 7")]
        [TestCase("\"cut\":", "not JSON at line 1")]
        public void History_BrokenSession_IsNamed_AndAFolderOfSuchIsRefusedWithTheReason(string field, string words)
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("broken.json"), "{\"kind\":\"camera\"," + field + "}");
            CommandLine.AssertRefused(words, "calibrate", "history", folder.Path);
            File.WriteAllText(folder.File("good.json"), "{\"v\":1,\"kind\":\"camera\",\"date\":\"2026-01-01\",\"rms_px\":0.2}");
            (int exitCode, string output, string error) = CommandLine.Run("calibrate", "history", folder.Path);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(error, Does.Match("^range: [^\n]*broken.json: [^\n]+\n$").And.Contain(words));
            Assert.That(output, Does.Contain("best: good.json, 0.2000 px").And.Not.Contain("broken"));
        }

        private static string Calibrate(TemporaryFolder folder, string noise, params string[] options)
        {
            (int exitCode, _, string error) = Run(folder, noise, options);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            return folder.File("camera.json");
        }

        private static (int ExitCode, string Output, string Error) Run(TemporaryFolder folder, string noise, params string[] options)
        {
            string corners = folder.File("corners.json");
            CommandLine.Run("calibrate", "simulate", "--views", "20", "--noise", noise, "--out", corners);
            return CommandLine.Run(["calibrate", "board", "--corners", corners, .. options.Contains("--out") ? Array.Empty<string>() : ["--out", folder.File("camera.json")], .. options]);
        }
    }
}
