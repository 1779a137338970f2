using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Commands;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Studies;
using LaserTracking.Host.Tracks;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    /// <summary>The dot tracker on the reference scenes, beside SORT with boxes inflated for it.</summary>
    [Category("Reference")]
    public sealed class DotTrackerReferenceTests
    {
        private const int KeptFrames = 50;
        private const int LongestGapFrames = 24;

        private static IEnumerable<TestCaseData> Scenes() => ClearMotScenes.All();

        [TestCaseSource(nameof(Scenes))]
        public void Track_Dots_BeatInflatedSortByTwoPointsAndKeepTheirIdentity(string scene)
        {
            TrackMetrics ours = Metrics(scene, Track(scene));
            double theirs = ((JObject)JObject.Parse(File.ReadAllText(Path.Combine(scene, "metrics.json")))["results"]!).Properties()
                .Where(result => result.Name.Contains("inflated")).Max(result => (double)result.Value["centre_dist_20px"]!["mota"]!);
            TestContext.Out.WriteLine(FormattableString.Invariant($"MOTA {100 * ours.Mota:F1} % (reference {100 * theirs:F1}), IDF1 {100 * ours.IdentityF1:F1} %, {ours.Switches} switches"));
            Assert.That(ours.Mota, Is.GreaterThanOrEqualTo(theirs + 0.02));
            Assert.That(ours.IdentityF1, Is.GreaterThanOrEqualTo(0.8));
        }

        [Test]
        public void Track_Dots_KeepTheirNumbersOverFramesAndGaps()
        {
            Proportion kept = default, afterGaps = default, afterLongGaps = default;
            foreach (string scene in Scenes().Select(data => (string)data.Arguments[0]!))
            {
                var keeping = new IdentityKeeping(MotFile.Read(Path.Combine(scene, "gt.txt")), Track(scene));
                kept = Sum(kept, keeping.KeptOver(KeptFrames));
                afterGaps = Sum(afterGaps, keeping.KeptThroughGaps(3, LongestGapFrames));
                afterLongGaps = Sum(afterLongGaps, keeping.KeptThroughGaps(15, LongestGapFrames));
            }

            if (kept.Of == 0)
                Assert.Ignore("reference data not there: " + Path.Combine(TestFiles.Data, "clearmot"));
            TestContext.Out.WriteLine($"kept over {KeptFrames} frames: {kept}; through gaps of 3–{LongestGapFrames}: {afterGaps}; of 15–{LongestGapFrames}: {afterLongGaps}");
            Assert.That(kept.Share, Is.GreaterThanOrEqualTo(0.99));
            Assert.That(afterGaps.Share, Is.GreaterThanOrEqualTo(0.95));
            Assert.That(afterLongGaps.Share, Is.GreaterThanOrEqualTo(0.95));
        }

        private static Proportion Sum(Proportion a, Proportion b) => new(a.Count + b.Count, a.Of + b.Of);

        private static List<MotRow> Track(string scene)
        {
            using var folder = new TemporaryFolder();
            string output = folder.File("tracks.txt");
            (int exitCode, string _, string error) = CommandLine.Run("track", Path.Combine(scene, "det.txt"), "--tracker", "dots", "--out", output);
            Assert.That(exitCode, Is.Zero, error);
            return MotFile.ReadTracks(output, mayBeEmpty: false);
        }

        private static TrackMetrics Metrics(string scene, List<MotRow> tracks)
        {
            List<MotRow> truth = MotFile.ReadTracks(Path.Combine(scene, "gt.txt"), mayBeEmpty: false);
            return TrackEvaluator.Evaluate(truth, tracks, TrackMatch.Centre20, Math.Max(truth[^1].Frame, tracks[^1].Frame));
        }
    }
}
