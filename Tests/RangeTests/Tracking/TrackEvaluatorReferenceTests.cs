using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Commands;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Tracks;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    /// <summary>The evaluator beside py-motmetrics: counts exactly, ratios to 1e-6.</summary>
    [Category("Reference")]
    public sealed class TrackEvaluatorReferenceTests
    {
        private static readonly (string Ours, string Theirs)[] TudNames =
        {
            ("mota", "mota"), ("motp", "motp"), ("idf1", "idf1"), ("num_switches", "switches"), ("num_false_positives", "fp"), ("num_misses", "fn"), ("num_fragmentations", "frag"),
            ("num_objects", "objects"), ("mostly_tracked", "mt"), ("partially_tracked", "pt"), ("mostly_lost", "ml"), ("precision", "precision"), ("recall", "recall"),
        };

        [Test]
        public void Evaluate_TinyCases_HaveTheReferenceMetrics()
        {
            foreach (JProperty test in ((JObject)JObject.Parse(File.ReadAllText(TestFiles.Reference("clearmot", "tiny_cases.json")))["cases"]!).Properties())
            {
                TrackMetrics metrics = TrackEvaluator.Evaluate(Rows(test.Value["gt"]!), Rows(test.Value["hyp"]!), TrackMatch.Centre20, (int)test.Value["frames"]!);
                AssertEqual(JObject.Parse(metrics.ToJson()), (JObject)test.Value["metrics_centre_dist_20px"]!, test.Name);
            }
        }

        private static IEnumerable<TestCaseData> Scenes() => ClearMotScenes.All();

        [TestCaseSource(nameof(Scenes))]
        public void ScoreTracks_ReferenceTracks_HaveTheReferenceMetrics(string scene)
        {
            JObject reference = JObject.Parse(File.ReadAllText(Path.Combine(scene, "metrics.json")));
            int compared = 0;
            foreach (JProperty tracks in ((JObject)reference["results"]!).Properties())
            {
                foreach ((string option, string name) in new[] { ("iou0.5", "iou_match_0.5"), ("centre20", "centre_dist_20px") })
                {
                    (int exitCode, string output, string error) = CommandLine.Run("score-tracks", Path.Combine(scene, "gt.txt"), Path.Combine(scene, tracks.Name + ".txt"), "--match", option, "--frames", (string)reference["frames"]!);
                    Assert.That(exitCode, Is.Zero, error);
                    AssertEqual(JObject.Parse(output), (JObject)tracks.Value[name]!, tracks.Name + ", " + name);
                    compared++;
                }
            }

            Assert.That(compared, Is.Positive);
        }

        /// <summary>
        /// The truth of these sequences may not be stored with the figures; where it lies beside them as gt.txt all is compared. The figures
        /// were made from the two decimals that the authors' program writes.
        /// </summary>
        [Test]
        public void Evaluate_PedestrianSequences_HaveTheReferenceMetrics()
        {
            int compared = 0;
            foreach (JProperty result in ((JObject)JObject.Parse(File.ReadAllText(TestFiles.Reference("sort", "clearmot_TUD.json")))["results"]!).Properties())
            {
                string[] name = result.Name.Split('/');
                string truth = Path.Combine(TestFiles.Data, "sort", name[0], "gt.txt");
                List<MotRow> tracks = MotFile.ReadTracks(TestFiles.Reference("sort", name[0], "ref_" + name[1] + ".txt"), mayBeEmpty: false);
                JToken expected = result.Value;
                int objects = (int)expected["objects"]!, found = objects - (int)expected["fn"]!, switches = (int)expected["switches"]!;
                var counted = new TrackMetrics { Objects = objects, Predictions = tracks.Count, Matches = found - switches, Switches = switches };
                Assert.That(counted.FalsePositives, Is.EqualTo((int)expected["fp"]!), result.Name);
                Assert.That(counted.Mota, Is.EqualTo((double)expected["mota"]!).Within(1e-6), result.Name);
                Assert.That(counted.Precision, Is.EqualTo((double)expected["precision"]!).Within(1e-6), result.Name);
                Assert.That(counted.Recall, Is.EqualTo((double)expected["recall"]!).Within(1e-6), result.Name);
                if (!File.Exists(truth))
                    continue;
                JObject metrics = JObject.Parse(TrackEvaluator.Evaluate(MotFile.ReadTracks(truth, mayBeEmpty: false), tracks.ConvertAll(TwoDecimals), TrackMatch.Iou05, tracks[^1].Frame).ToJson());
                foreach ((string ours, string theirs) in TudNames)
                    Assert.That((double)metrics[ours]!, Is.EqualTo((double)expected[theirs]!).Within(1e-6), result.Name + ", " + theirs);
                compared++;
            }

            if (compared == 0)
                Assert.Ignore("reference data not there: the truth of the sequences in clearmot_TUD.json, as sort/SEQUENCE/gt.txt; only sums were compared");
        }

        private static MotRow TwoDecimals(MotRow row) =>
            row with { Box = new BoundingBox(Math.Round(row.Box.X, 2), Math.Round(row.Box.Y, 2), Math.Round(row.Box.Width, 2), Math.Round(row.Box.Height, 2)) };

        private static void AssertEqual(JObject actual, JObject expected, string where)
        {
            foreach (JProperty value in expected.Properties())
            {
                JToken ours = actual[value.Name] ?? throw new AssertionException(where + ": there is no " + value.Name);
                if (value.Value.Type == JTokenType.Null)
                    Assert.That(ours.Type, Is.EqualTo(JTokenType.Null), where + ", " + value.Name);
                else if (value.Value.Type == JTokenType.Integer)
                    Assert.That((long)ours, Is.EqualTo((long)value.Value), where + ", " + value.Name);
                else
                    Assert.That((double)ours, Is.EqualTo((double)value.Value).Within(1e-6), where + ", " + value.Name);
            }
        }

        private static List<MotRow> Rows(JToken rows) => rows
            .Select(row => new MotRow((int)row[0]!, (int)row[1]!, new BoundingBox((double)row[2]!, (double)row[3]!, (double)row[4]!, (double)row[5]!), 1)).OrderBy(row => row.Frame).ToList();
    }
}
