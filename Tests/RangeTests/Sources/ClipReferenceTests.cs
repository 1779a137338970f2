using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Host.Sources;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Sources
{
    /// <summary>Frame numbers and times of real webcam clips beside their hand-made truth.</summary>
    public sealed class ClipReferenceTests
    {
        private static IEnumerable<string> Clips()
        {
            string truth = Path.Combine(TestFiles.Data, "clips", "truth.json");
            return File.Exists(truth) ? JObject.Parse(File.ReadAllText(truth))["clips"]!.Select(clip => (string)clip["file"]!) : [];
        }

        [TestCaseSource(nameof(Clips))]
        public void TryRead_Clip_HasTheFramesAndTimesOfItsTruth(string file)
        {
            FfmpegForTests.Run("-version");
            JToken clip = JObject.Parse(File.ReadAllText(TestFiles.Reference("clips", "truth.json")))["clips"]!.Single(c => (string)c["file"]! == file);
            string path = TestFiles.Reference("clips", file);
            using var source = new VideoSource(path);
            Assert.That((source.Info.Width, source.Info.Height), Is.EqualTo(((int)clip["width"]!, (int)clip["height"]!)));
            using var frame = new Frame();
            var times = new List<long>();
            while (source.TryRead(frame))
            {
                Assert.That(frame.Index, Is.EqualTo(times.Count));
                times.Add(frame.TimeUs);
            }

            Assert.That(times, Has.Count.EqualTo((int)clip["frames"]!));
            Assert.That(times, Is.Ordered);
            Assert.That(source.Problems, Is.Empty);
            foreach (JToken shot in clip["shots"]!)
            {
                double expected = (double)shot["first_visible_t_s"]!;
                Assert.That(times[(int)shot["first_visible_frame"]!] * 1e-6, Is.EqualTo(expected).Within(0.0001), (string)shot["id"]!);
            }

            Assert.That((long)VideoInfo.OfVideo(path)["captures"]!, Is.EqualTo(times.Count));
        }
    }
}
