using System;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class TrackCommandTests
    {
        private const string Good = "1,-1,10,10,20,20,1\n2,-1,11,10,20,20,1\n";

        [TestCase("", "is empty")]
        [TestCase("\n\n", "is empty")]
        [TestCase("1,-1,10,10,20,20,1\n\n2,-1,10,10,20,20,1\n", "line 2 is empty")]
        [TestCase("1,-1,nan,10,20,20,1\n", "line 1 field x: \"nan\" is no finite number")]
        [TestCase("1,-1,10,inf,20,20,1\n", "line 1 field y")]
        [TestCase("1,-1,10,10,0,20,1\n", "line 1 field w: 0 is not above 0")]
        [TestCase("1,-1,10,10,20,-5,1\n", "line 1 field h: -5 is not above 0")]
        [TestCase(Good + "3,-1,10,10,20\n", "line 3 has 5 of at least 6 fields")]
        [TestCase(Good + "3;-1;10;10;20;20\n", "line 3 field frame")]
        [TestCase("0,-1,10,10,20,20\n", "field frame: 0")]
        [TestCase("1.5,-1,10,10,20,20\n", "field frame: 1.5")]
        [TestCase("1e300,-1,10,10,20,20\n", "field frame: 1E+300")]
        [TestCase("1,x,10,10,20,20\n", "field id: \"x\"")]
        [TestCase("1,-1,10,10,20,20,1,,-1\n", "field 7 after frame: \"\"")]
        [TestCase("1,-1,10,10,20,20,1,-1,-1,-1,-1\n", "more than 10 fields")]
        [TestCase("1,-1,1e20,10,20,20\n", "beyond any picture")]
        public void Track_BrokenDetections_AreRefusedWithoutAResult(string content, string words)
        {
            using var folder = new TemporaryFolder();
            string input = folder.File("det.txt"), output = folder.File("out.txt");
            File.WriteAllText(input, content);
            CommandLine.AssertRefused(words, "track", input, "--out", output);
            Assert.That(Directory.GetFiles(folder.Path), Is.EqualTo(new[] { input }));
        }

        [Test]
        public void Track_RandomBytes_AreRefusedInOneLine()
        {
            using var folder = new TemporaryFolder();
            string input = folder.File("det.txt");
            var random = new Random(2);
            for (int trial = 0; trial < 200; trial++)
            {
                byte[] bytes = Encoding.ASCII.GetBytes(Good);
                if (trial % 2 == 0)
                    random.NextBytes(bytes);
                else
                    bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
                File.WriteAllBytes(input, bytes);
                (int exitCode, string output, string error) = CommandLine.Run("track", input, "--out", folder.File("out.txt"));
                Assert.That(exitCode, Is.EqualTo(ExitCodes.Done).Or.EqualTo(ExitCodes.BadInput));
                Assert.That(output, Is.Empty);
                Assert.That(error, Does.Not.Contain("internal error"));
                Assert.That(error.Count(c => c == '\n'), Is.EqualTo(exitCode == ExitCodes.Done ? 0 : 1));
            }
        }

        [TestCase("sort")]
        [TestCase("dots")]
        public void Track_FramesOutOfOrder_GiveWhatFramesInOrderGive(string tracker)
        {
            using var folder = new TemporaryFolder();
            string[] lines = Enumerable.Range(1, 40).Where(f => f is < 20 or > 23).SelectMany(f => new[] { $"{f},-1,{10 + 3 * f},50,20,20,1", $"{f},-1,{300 - 3 * f},90,20,20,1" }).ToArray();
            File.WriteAllLines(folder.File("a.txt"), lines);
            File.WriteAllText(folder.File("b.txt"), string.Join("\r\n", lines.Reverse()));
            Run("track", folder.File("a.txt"), "--tracker", tracker, "--max-age", "10", "--out", folder.File("a.out"));
            Run("track", folder.File("b.txt"), "--tracker", tracker, "--max-age", "10", "--out", folder.File("b.out"));
            string[] a = File.ReadAllLines(folder.File("a.out")), b = File.ReadAllLines(folder.File("b.out"));
            Assert.That(a.Length, Is.GreaterThan(60));
            Assert.That(b.Select(WithoutId).Order(), Is.EqualTo(a.Select(WithoutId).Order()));
            Assert.That(a.Select(Id).Distinct().Count(), Is.EqualTo(2));
            Assert.That(b.Select(Id).Distinct().Count(), Is.EqualTo(2));
        }

        [TestCase("sort")]
        [TestCase("dots")]
        public void Track_AFarFrame_IsReachedAndTheTrackIsOver(string tracker)
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("a.txt"), Good + "3000000,-1,11,10,20,20,1\n3000001,-1,11,10,20,20,1\n");
            Run("track", folder.File("a.txt"), "--tracker", tracker, "--min-hits", "1", "--out", folder.File("out.txt"));
            string[] rows = File.ReadAllLines(folder.File("out.txt"));
            Assert.That(Id(rows[^1]), Is.EqualTo("2"));
        }

        [TestCase("sort", 256)]
        [TestCase("dots", 128)]
        public void Track_TenThousandDetectionsInAFrame_AreBoundedAndSaid(string tracker, int used)
        {
            using var folder = new TemporaryFolder();
            var random = new Random(1);
            File.WriteAllLines(folder.File("a.txt"), Enumerable.Range(0, 20_000).Select(i => FormattableString.Invariant($"{7 + i / 10_000},-1,{random.NextDouble() * 1900:F2},{random.NextDouble() * 1000:F2},15,15,1")));
            (int exitCode, string _, string error) = CommandLine.Run("track", folder.File("a.txt"), "--tracker", tracker, "--out", folder.File("out.txt"));
            Assert.That(exitCode, Is.Zero);
            Assert.That(error.TrimEnd(), Does.Contain("too many detections in 2 frame(s)").And.Contain((10_000 - used) + " of 10000 were not used").And.Not.Contain("\n"));
            Assert.That(File.Exists(folder.File("out.txt")), Is.True);
        }

        [TestCase("--iou: does not apply", "--tracker", "dots", "--iou", "0.5")]
        [TestCase("--fps: does not apply", "--fps", "30")]
        [TestCase("--iou: 2 is not in 0…1", "--iou", "2")]
        [TestCase("--max-age: -1 is not in", "--max-age", "-1")]
        [TestCase("--min-hits: 0 is not in 1…60", "--tracker", "dots", "--min-hits", "0")]
        [TestCase("--width: NaN is not in", "--tracker", "dots", "--width", "NaN")]
        public void Track_SettingsOutsideTheirRange_AreNamed(string words, params string[] arguments)
        {
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("a.txt"), Good);
            CommandLine.AssertRefused(words, ["track", folder.File("a.txt"), "--out", folder.File("out.txt"), .. arguments]);
            CommandLine.AssertRefused("this file is also read", "track", folder.File("a.txt"), "--out", folder.File("a.txt"));
            Assert.That(File.Exists(folder.File("out.txt")), Is.False);
        }

        [Test]
        public void ScoreTracks_BrokenFiles_AreRefused()
        {
            using var folder = new TemporaryFolder();
            string truth = folder.File("gt.txt"), tracks = folder.File("tracks.txt"), empty = folder.File("empty.txt");
            File.WriteAllText(truth, "1,1,10,10,20,20,1\n2,1,11,10,20,20,1\n");
            File.WriteAllText(tracks, "1,4,10,10,20,20\n1,4,60,10,20,20\n");
            File.WriteAllText(empty, string.Empty);
            File.WriteAllText(folder.File("ignored.txt"), "1,1,10,10,20,20,0\n");
            CommandLine.AssertRefused("frame 1 holds id 4 twice", "score-tracks", truth, tracks);
            CommandLine.AssertRefused("is empty", "score-tracks", empty, truth);
            CommandLine.AssertRefused("nothing counts", "score-tracks", folder.File("ignored.txt"), truth);
            CommandLine.AssertRefused("is not there", "score-tracks", truth, folder.File("no.txt"));
            CommandLine.AssertRefused("--frames: 1 is less than 2", "score-tracks", truth, truth, "--frames", "1");
            Assert.That(Run("score-tracks", truth, empty), Does.Contain("\"mota\": 0,").And.Contain("\"motp\": null"));
            Assert.That(Run("score-tracks", truth, truth), Does.Contain("\"idf1\": 1,"));
        }

        [Test]
        public void ScoreTracks_MoreBoxesThanCanBeCompared_IsSaid()
        {
            using var folder = new TemporaryFolder();
            File.WriteAllLines(folder.File("gt.txt"), Enumerable.Range(1, 10_000).Select(i => $"1,{i},{i % 100 * 10},{i / 100 * 10},9,9,1"));
            CommandLine.AssertRefused("frame 1 holds 10000 boxes, at most 1000", "score-tracks", folder.File("gt.txt"), folder.File("gt.txt"));
        }

        private static string Run(params string[] arguments)
        {
            (int exitCode, string output, string error) = CommandLine.Run(arguments);
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(error, Is.Empty);
            return output;
        }

        private static string Id(string row) => row.Split(',')[1];

        private static string WithoutId(string row) => string.Join(',', row.Split(',').Where((_, i) => i != 1));
    }
}
