using System;
using System.IO;
using System.Linq;
using LaserTracking.Host;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>Damaged recordings by command line: a result that says what is wrong with its input, or one line and no result.</summary>
    [Category("Reference")]
    public sealed class DamagedInputTests
    {
        private static readonly string[] BadFiles =
        {
            "bad_corrupt_block_size.mkv", "bad_corrupt_payload.mkv", "bad_empty.mkv", "bad_not_matroska.mkv", "bad_truncated_header.mkv",
            "bad_truncated_mid_cluster.mkv", "bad_unflushed.mkv",
        };

        [TestCaseSource(nameof(BadFiles))]
        public void Commands_DamagedRecording_GiveResultOrOneLine(string name)
        {
            string file = TestFiles.Reference("k4a", name);
            if (name is "bad_empty.mkv" or "bad_not_matroska.mkv" or "bad_truncated_header.mkv")
                AssertRefusedEverywhere(file);
            else
                AssertUsedEverywhere(file);
        }

        [TestCase(0.02)]
        [TestCase(0.31)]
        [TestCase(0.77)]
        [TestCase(0.999)]
        public void Commands_CutRecording_GiveWhatIsThereAndSayThatItIsCut(double share)
        {
            using var folder = new TemporaryFolder();
            byte[] bytes = File.ReadAllBytes(TestFiles.Reference("k4a", "rec_small.mkv"));
            string file = folder.File("cut.mkv");
            File.WriteAllBytes(file, bytes[..(int)(bytes.Length * share)]);
            AssertUsedEverywhere(file);
            Assert.That((bool)Info(file)["truncated"]!, Is.True);
        }

        [Test]
        public void Commands_TagAgainstTrack_FollowTheTrackAndSaySo()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("tag.mkv");
            Replace(TestFiles.Reference("k4a", "rec_small.mkv"), file, "MJPG_720P"u8, "NV12_720P"u8);
            JObject info = Info(file);
            Assert.That((string)info["tracks"]![0]!["format"]!, Is.EqualTo("MJPG"));
            Assert.That(info["problems"]!.Select(p => (string)p["what"]!), Has.Some.Contains("K4A_COLOR_MODE"));
            Assert.That(Health(file), Has.Some.Contains("K4A_COLOR_MODE"));
        }

        [Test]
        public void Replay_HalfAJpeg_LosesThatPictureAlone()
        {
            using var folder = new TemporaryFolder();
            byte[] bytes = File.ReadAllBytes(TestFiles.Reference("k4a", "rec_small.mkv"));
            int at = 0;
            for (int picture = 0; picture < 3; picture++)
                at += 1 + bytes.AsSpan(at + 1).IndexOf(new byte[] { 0xFF, 0xD8, 0xFF });
            int length = bytes.AsSpan(at).IndexOf(new byte[] { 0xFF, 0xD9 });
            bytes.AsSpan(at + length / 2, length - length / 2 + 2).Clear();
            string file = folder.File("half.mkv");
            File.WriteAllBytes(file, bytes);
            Assert.That(Health(file), Has.Some.Contains("COLOR picture is missing: JPEG"));
            JObject end = JObject.Parse(Events(file)[^1]);
            Assert.That(((int)end["frames"]!, (int)end["dropped"]!), Is.EqualTo((12, 1)));
        }

        [Test]
        public void Replay_NoPictureIsWhole_CountsEveryFrameAsDropped()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("none.mkv");
            Replace(TestFiles.Reference("k4a", "rec_small.mkv"), file, new byte[] { 0xFF, 0xD8, 0xFF }, new byte[3]);
            JObject end = JObject.Parse(Events(file)[^1]);
            Assert.That(((int)end["frames"]!, (int)end["dropped"]!), Is.EqualTo((12, 12)), "the two captures with infrared show the detector nothing either");
        }

        [Test]
        public void Replay_CalibrationOfOtherPictures_SaysSo()
        {
            using var folder = new TemporaryFolder();
            string calibration = folder.File("screen.json"), file = TestFiles.Reference("k4a", "rec_small.mkv");
            CommandLine.Run("calibrate", "screen", "--size", "3x2", "--image-size", "1920x1080", "--out", calibration, "--corners", "150,82", "1138,104", "1110,640", "182,622");
            Assert.That(Health(file, "--calibration", calibration), Has.Some.Contains("1920×1080, these have 1280×720"));
            Assert.That(Health(file), Has.None.Contains("1920"));
        }

        [Test]
        public void Replay_HandRecordingThatCannotHelp_SaysSo()
        {
            using var folder = new TemporaryFolder();
            string calibration = folder.File("screen.json"), file = TestFiles.Reference("k4a", "rec_small.mkv"), hand = TestFiles.Reference("k4a", "rec_hand_nfov.mkv");
            string colorAlone = TestFiles.Reference("k4a", "rec_minimal_no_device.mkv");
            CommandLine.Run("calibrate", "screen", "--size", "3x2", "--out", calibration, "--corners", "150,82", "1138,104", "1110,640", "182,622");
            JObject content = JObject.Parse(File.ReadAllText(calibration));
            content["hand_camera"] = JObject.Parse("{\"image_size\":[640,576],\"K\":[[500,0,320],[0,500,288],[0,0,1]],\"R\":[[1,0,0],[0,1,0],[0,0,1]],\"T\":[0,0,-2000]}");
            File.WriteAllText(calibration, content.ToString());
            CommandLine.AssertRefused("holds no depth", "replay", file, "--calibration", calibration, "--hand", colorAlone);
            Assert.That(Health(file, "--calibration", calibration, "--hand", hand, "--hand-offset-us", "99000000"), Has.Some.Contains("--hand-offset-us"));
            Assert.That(Health(hand, "--calibration", calibration, "--hand", hand), Has.None.Contains("second camera"));
        }

        [Test]
        public void Extract_CapturesThatAreNotThere_IsRefused()
        {
            using var folder = new TemporaryFolder();
            string output = folder.File("out");
            CommandLine.AssertRefused("has no capture 100", "extract", TestFiles.Reference("k4a", "rec_small.mkv"), "--out", output, "--captures", "100..200");
            Assert.That(Directory.GetFiles(output), Is.Empty);
        }

        private static void AssertRefusedEverywhere(string file)
        {
            using var folder = new TemporaryFolder();
            CommandLine.AssertRefused(file + ": ", "info", file);
            CommandLine.AssertRefused(file + ": ", "extract", file, "--out", folder.File("out"));
            CommandLine.AssertRefused(file + ": ", "replay", file, "--events", folder.File("events.jsonl"), "--report", folder.File("report"));
            Assert.That(Directory.GetFileSystemEntries(folder.Path), Is.Empty);
        }

        private static void AssertUsedEverywhere(string file)
        {
            using var folder = new TemporaryFolder();
            JObject info = Info(file);
            Assert.That(info["problems"]!, Is.Not.Empty);
            (int exitCode, string output, _) = CommandLine.Run("extract", file, "--out", folder.File("out"), "--hashes-only");
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(output, Does.StartWith(info["captures"] + " captures"));
            Assert.That(Directory.GetFiles(folder.File("out")).Select(Path.GetFileName), Is.EqualTo(new[] { "frames.jsonl" }));
            Assert.That(Health(file), Is.Not.Empty);
        }

        private static JObject Info(string file)
        {
            (int exitCode, string output, string error) = CommandLine.Run("info", file);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            return JObject.Parse(output);
        }

        private static string[] Health(string file, params string[] options) =>
            Events(file, options).Where(line => line.StartsWith("{\"type\":\"health\"", StringComparison.Ordinal)).ToArray();

        private static string[] Events(string file, params string[] options)
        {
            using var folder = new TemporaryFolder();
            (int exitCode, _, string error) = CommandLine.Run(["replay", file, "--events", folder.File("events.jsonl"), .. options]);
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(Directory.GetFiles(folder.Path), Has.Length.EqualTo(1));
            return File.ReadAllLines(folder.File("events.jsonl"));
        }

        private static void Replace(string from, string to, ReadOnlySpan<byte> old, ReadOnlySpan<byte> changed)
        {
            byte[] bytes = File.ReadAllBytes(from);
            int count = 0;
            for (int at = bytes.AsSpan().IndexOf(old); at >= 0; at = bytes.AsSpan().IndexOf(old), count++)
                changed.CopyTo(bytes.AsSpan(at));
            Assert.That(count, Is.GreaterThan(0));
            File.WriteAllBytes(to, bytes);
        }
    }
}
