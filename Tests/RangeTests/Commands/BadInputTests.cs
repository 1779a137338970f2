using System.IO;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class BadInputTests
    {
        private static readonly string Scene = Path.Combine(TestFiles.Repository, "Assets", "Scenes", "Range.unity");

        [Test]
        public void Inputs_Missing_AreNamed([Values("info", "replay", "extract")] string command)
        {
            using var folder = new TemporaryFolder();
            string missing = folder.File("sp ace ☃.mkv");
            string line = CommandLine.AssertRefused(missing + ": ", command == "extract" ? [command, missing, "--out", folder.File("out")] : [command, missing]);
            Assert.That(line, Does.Contain("exist").Or.Contain("no such file"));
            Assert.That(Directory.GetFileSystemEntries(folder.Path), Is.Empty);
        }

        [TestCase(new byte[0], "empty")]
        [TestCase(new byte[] { 0x1A, 0x45, 0xDF, 0xA3, 1, 2, 3 }, "not")]
        [TestCase(new byte[] { 1, 2, 3, 4, 5 }, "not a Matroska file (byte 0")]
        public void Extract_NoRecording_IsRefusedWithoutAResult(byte[] content, string words)
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("a.mkv"), output = folder.File("out");
            File.WriteAllBytes(file, content);
            string line = CommandLine.AssertRefused(file + ": ", "extract", file, "--out", output);
            Assert.That(line, Does.Contain(words).Or.Contain("cut off").Or.Contain("no Matroska segment"));
            Assert.That(Directory.Exists(output), Is.False);
        }

        [Test]
        public void Inputs_FolderInPlaceOfFile_AreRefused()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("a");
            File.WriteAllText(file, "{\"clips\":[{\"file\":\"a.mp4\",\"width\":640,\"shots\":[]}]}");
            CommandLine.AssertRefused("folder", "extract", folder.Path, "--out", folder.File("out"));
            CommandLine.AssertRefused("folder", "replay", file, "--calibration", folder.Path);
            CommandLine.AssertRefused("folder", "calibrate", "screen", "--size", "3x2", "--points", folder.Path);
            CommandLine.AssertRefused("folder", "score", folder.Path, file);
            CommandLine.AssertRefused("folder", "score", file, folder.Path);
            CommandLine.AssertRefused("folder without pictures", "replay", Directory.CreateDirectory(folder.File("empty")).FullName);
        }

        [Test]
        public void Replay_WhatIsMissing_IsSaidBeforeTheWork()
        {
            using var folder = new TemporaryFolder();
            string input = folder.File("a.mkv"), events = folder.File("events.jsonl");
            CommandLine.AssertRefused("add --calibration FILE", "replay", input, "--scene", Scene, "--events", events);
            CommandLine.AssertRefused("add --calibration FILE with a hand_camera", "replay", input, "--hand", input, "--events", events);
            CommandLine.AssertRefused("this file is also read", "replay", input, "--events", input);
            CommandLine.AssertRefused("no such file", "replay", input, "--calibration", folder.File("no.json"), "--events", events);
            Assert.That(Directory.GetFileSystemEntries(folder.Path), Is.Empty);
        }

        [Test]
        public void Demo_FileInPlaceOfTheFolder_IsRefusedBeforeTheWork()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("a");
            File.WriteAllText(file, "kept");
            CommandLine.AssertRefused("is a file, not a folder", "demo", "--out", file);
            Directory.CreateDirectory(folder.File("b/report.html"));
            CommandLine.AssertRefused("report.html: this is no name for a file", "demo", "--out", folder.File("b"));
            Assert.That(Directory.GetFiles(folder.File("b")), Is.Empty);
            Assert.That(File.ReadAllText(file), Is.EqualTo("kept"));
        }

        [TestCase("", "empty")]
        [TestCase("{broken\n", "line 1")]
        [TestCase("{\"type\":\"shot\",\"frame\":1.5,\"x_px\":1,\"y_px\":1}\n", "field \"frame\"")]
        [TestCase("{\"type\":\"shot\",\"frame\":1,\"x_px\":\"a\",\"y_px\":1}\n", "field \"x_px\"")]
        [TestCase("{\"type\":\"shot\",\"frame\":1,\"x_px\":1e999,\"y_px\":1}\n", "field \"x_px\"")]
        public void Score_BrokenEvents_AreRefused(string content, string words)
        {
            using var folder = new TemporaryFolder();
            string events = folder.File("events.jsonl"), truth = folder.File("truth.json");
            File.WriteAllText(events, content);
            File.WriteAllText(truth, "{\"clips\":[{\"file\":\"a.mp4\",\"width\":640,\"shots\":[]}]}");
            CommandLine.AssertRefused(words, "score", events, truth);
        }

        [TestCase("[", "no JSON")]
        [TestCase("{}", "has neither")]
        [TestCase("{\"clips\":[]}", "has 0 clips")]
        [TestCase("{\"clips\":[{}]}", "clips[0].file is missing")]
        [TestCase("{\"clips\":[{\"file\":\"a\",\"shots\":[{}]}]}", "missing")]
        [TestCase("{\"clips\":[{\"file\":\"b\",\"width\":9,\"shots\":[]},{\"file\":\"c\",\"width\":9,\"shots\":[]}]}", "none is named")]
        public void Score_OtherTruth_IsRefused(string content, string words)
        {
            using var folder = new TemporaryFolder();
            string events = folder.File("events.jsonl"), truth = folder.File("truth.json");
            File.WriteAllText(events, "{\"type\":\"header\",\"v\":1,\"inputs\":[{\"path\":\"a.mp4\"}]}\n");
            File.WriteAllText(truth, content);
            CommandLine.AssertRefused(words, "score", events, truth);
        }

        [Test]
        public void Doctor_Always_NamesEachPart()
        {
            (int exitCode, string output, string error) = CommandLine.Run("doctor");
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(error, Is.Empty);
            Assert.That(output, Does.Contain(".NET").And.Contain("ffmpeg").And.Contain("disk").And.Contain("clock"));
        }
    }
}
