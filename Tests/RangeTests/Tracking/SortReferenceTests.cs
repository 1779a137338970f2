using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using LaserTracking.Commands;
using LaserTracking.Host.Tracks;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    /// <summary>SORT beside the authors' program: every sequence, every frame, every box, and the filters' inside.</summary>
    [Category("Reference")]
    public sealed partial class SortReferenceTests
    {
        private const double TolerancePx = 1e-3;

        private static IEnumerable<TestCaseData> Sequences()
        {
            string folder = Path.Combine(TestFiles.Data, "sort");
            string[] references = Directory.Exists(folder) ? Directory.GetFiles(folder, "ref_maxage*.txt", SearchOption.AllDirectories) : [];
            foreach (string reference in references.Order(StringComparer.Ordinal))
            {
                Match name = MaxAge().Match(Path.GetFileName(reference));
                string sequence = Path.GetDirectoryName(reference)!;
                if (name.Success && File.Exists(Path.Combine(sequence, "det.txt")))
                    yield return new TestCaseData(sequence, name.Groups[1].Value).SetArgDisplayNames(Path.GetFileName(sequence), name.Groups[1].Value);
            }
        }

        [TestCaseSource(nameof(Sequences))]
        public void Track_Sequence_EqualsTheReferenceOnEveryFrame(string sequence, string maxAge)
        {
            using var folder = new TemporaryFolder();
            string output = folder.File("tracks.txt");
            (int exitCode, string _, string error) = CommandLine.Run("track", Path.Combine(sequence, "det.txt"), "--max-age", maxAge, "--out", output);
            Assert.That(exitCode, Is.Zero, error);
            Assert.That(error, Is.Empty);
            List<MotRow> expected = MotFile.ReadTracks(Path.Combine(sequence, $"ref_maxage{maxAge}.txt"), mayBeEmpty: true);
            List<MotRow> actual = MotFile.ReadTracks(output, mayBeEmpty: true);
            Assert.That(actual.Select(row => row.Frame), Is.EqualTo(expected.Select(row => row.Frame)), "boxes per frame");
            var ours = new Dictionary<int, int>();
            var theirs = new Dictionary<int, int>();
            ILookup<int, MotRow> actualOfFrame = actual.ToLookup(row => row.Frame);
            double worst = 0;
            foreach (IGrouping<int, MotRow> frame in expected.GroupBy(row => row.Frame))
            {
                List<MotRow> left = actualOfFrame[frame.Key].ToList();
                foreach (MotRow box in frame)
                {
                    MotRow partner = left.MinBy(other => Deviation(box.Box, other.Box));
                    left.Remove(partner);
                    worst = Math.Max(worst, Deviation(box.Box, partner.Box));
                    Assert.That(worst, Is.LessThanOrEqualTo(TolerancePx), $"frame {frame.Key}, id {box.Id}");
                    Assert.That(ours.TryAdd(box.Id, partner.Id) || ours[box.Id] == partner.Id, Is.True, $"frame {frame.Key}: id {box.Id} has become two");
                    Assert.That(theirs.TryAdd(partner.Id, box.Id) || theirs[partner.Id] == box.Id, Is.True, $"frame {frame.Key}: id {box.Id} is another's too");
                }
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"{expected.Count} boxes, {ours.Count} ids, worst deviation {worst:E1} px"));
        }

        private static IEnumerable<string> Traces()
        {
            string folder = Path.Combine(TestFiles.Data, "sort");
            return Directory.Exists(folder) ? Directory.GetFiles(folder, "trace_*.json").Order(StringComparer.Ordinal).Select(path => Path.GetFileName(path)) : [];
        }

        [TestCaseSource(nameof(Traces))]
        public void SortTracker_EveryFrame_HasTheStatesOfTheTrace(string trace)
        {
            JObject reference = JObject.Parse(File.ReadAllText(TestFiles.Reference("sort", trace)));
            ILookup<int, MotRow> rows = MotFile.Read(TestFiles.Reference("sort", (string)reference["sequence"]!, "det.txt")).ToLookup(row => row.Frame);
            var tracker = new SortTracker(new SortTrackerSettings { MaxAge = (int)reference["max_age"]!, MinHits = (int)reference["min_hits"]!, IouThreshold = (double)reference["iou_threshold"]! });
            int compared = 0;
            foreach (JToken frame in reference["frames"]!)
            {
                tracker.Process(rows[(int)frame["frame"]!].Select(row => row.Box).ToArray());
                JToken[] expected = frame["tracks_after"]!.ToArray();
                Assert.That(tracker.Tracks.Length, Is.EqualTo(expected.Length), "frame " + frame["frame"]);
                foreach (JToken track in expected)
                {
                    compared++;
                    AssertState(tracker.Tracks.ToArray().MinBy(t => Math.Abs(t.CenterX.Position - (double)track["x"]![0]!) + Math.Abs(t.CenterY.Position - (double)track["x"]![1]!)), track, $"frame {frame["frame"]}, id {track["id"]}");
                }
            }

            Assert.That(compared, Is.Positive);
        }

        private static void AssertState(SortTrack track, JToken expected, string where)
        {
            double[] state = { track.CenterX.Position, track.CenterY.Position, track.Area.Position, track.Aspect, track.CenterX.Velocity, track.CenterY.Velocity, track.Area.Velocity };
            double[] variances =
            {
                track.CenterX.PositionVariance, track.CenterY.PositionVariance, track.Area.PositionVariance, track.AspectVariance,
                track.CenterX.VelocityVariance, track.CenterY.VelocityVariance, track.Area.VelocityVariance,
            };

            // The trace has 12 significant digits.
            for (int i = 0; i < state.Length; i++)
            {
                double x = (double)expected["x"]![i]!, p = (double)expected["Pdiag"]![i]!;
                Assert.That(state[i], Is.EqualTo(x).Within(1e-6 + 1e-9 * Math.Abs(x)), where + ", state " + i);
                Assert.That(variances[i], Is.EqualTo(p).Within(1e-6 + 1e-9 * p), where + ", variance " + i);
            }

            Assert.That((track.Hits, track.HitStreak, track.Age, track.TimeSinceUpdate),
                Is.EqualTo(((int)expected["hits"]!, (int)expected["hit_streak"]!, (int)expected["age"]!, (int)expected["time_since_update"]!)), where);
        }

        private static double Deviation(in BoundingBox a, in BoundingBox b) =>
            Math.Max(Math.Max(Math.Abs(a.X - b.X), Math.Abs(a.Y - b.Y)), Math.Max(Math.Abs(a.Width - b.Width), Math.Abs(a.Height - b.Height)));

        [GeneratedRegex(@"^ref_maxage(\d+)\.txt$")]
        private static partial Regex MaxAge();
    }
}
