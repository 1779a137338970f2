using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Host;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Sources;
using LaserTracking.Session;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>The default detector on real webcam clips with hand-verified truth: any number of clips of the same layout.</summary>
    [Category("Reference")]
    public sealed class ClipShotsTests
    {
        private const double LeastFound = 0.99;
        private const double MostFalsePerShot = 0.01;

        [Test]
        public void ShotDetector_RealClips_FindsTheShotsAndHardlyAnythingElse()
        {
            string truth = TestFiles.Reference("clips", "truth.json");
            if (Prerequisites.Locate("ffmpeg") == null)
                Assert.Ignore("ffmpeg is not installed");
            int shots = 0, found = 0, wrong = 0, rightColor = 0;
            var report = new List<string>();
            foreach (string name in JObject.Parse(File.ReadAllText(truth))["clips"]!.Select(c => (string)c["file"]!))
            {
                string clip = TestFiles.Reference("clips", name);
                JToken result = Score(clip, truth, name);
                shots += (int)result["shots"]!;
                found += (int)result["found"]!;
                wrong += (int)result["false"]!;
                rightColor += (int)result["color_ok"]!;
                report.Add($"{name}: {result["found"]} of {result["shots"]}, {result["false"]} false, colour {result["color_ok"]}");
            }

            string all = string.Join(Environment.NewLine, report);
            Assert.That(found, Is.GreaterThanOrEqualTo(Math.Floor(LeastFound * shots)), all);
            Assert.That(wrong, Is.LessThanOrEqualTo(Math.Ceiling(MostFalsePerShot * shots)), all);
            Assert.That(rightColor, Is.GreaterThanOrEqualTo(Math.Floor(LeastFound * shots)), all);
        }

        [Test]
        public void ShotDetector_LaserRecordingThroughTheManagedReader_IsRightInEveryShot()
        {
            string recording = TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv"), truth = TestFiles.Reference("k4a", "rec_laser_720p_mjpg.truth.json");
            JToken result = Score(recording, truth, "rec_laser_720p_mjpg.mkv");
            Assert.That((int)result["shots"]!, Is.EqualTo(4));
            Assert.That((int)result["found"]!, Is.EqualTo(4));
            Assert.That((int)result["false"]!, Is.EqualTo(0));
            Assert.That((int)result["color_ok"]!, Is.EqualTo(4));
            Assert.That((double)result["error_px_median"]!, Is.LessThan(0.2));
        }

        private static JToken Score(string clip, string truth, string name)
        {
            using var folder = new TemporaryFolder();
            string events = Path.Combine(folder.Path, "events.jsonl");
            using (IFrameSource source = FrameSources.OpenScreenCamera(clip))
            using (var file = new FileStream(events, FileMode.Create))
                RangeSession.Run(new SessionPlan { ScreenCamera = source }, new JsonLinesSink(file, EventTypes.Shots), default);
            return JObject.Parse(EventScorer.Score(events, truth, name))["clips"]![0]!;
        }
    }
}
