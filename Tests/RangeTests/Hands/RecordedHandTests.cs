using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>The trackers on recordings of a hand whose path is known, with and without lost depth.</summary>
    [Category("Reference")]
    public sealed class RecordedHandTests
    {
        [TestCase("rec_hand_nfov")]
        [TestCase("rec_hand_binned")]
        public void DepthHandTracker_OnARecording_PalmWithinFifteenMillimetresInEveryCapture(string name)
        {
            int lost = 0, captures = 0;
            Run(name, camera => new DepthHandTracker(camera), (truth, hands) =>
            {
                captures++;
                Assert.That(hands.Hands.Length, Is.EqualTo(1), $"capture {truth["index"]}");
                HandObservation hand = hands.Hands[0];
                double error = (hand.PalmMm - Point(truth["palm_centre_mm"]!)).Length;
                bool isLost = (bool)truth["depth_lost_in_palm"]!;
                lost += isLost ? 1 : 0;
                TestContext.Out.WriteLine($"{name} {truth["index"]}: {error:F1} mm {hand.DepthSource}");
                Assert.That(error, Is.LessThan(15), $"capture {truth["index"]}");
                Assert.That(hand.DepthSource, Is.EqualTo(isLost ? DepthSource.Bridged : DepthSource.Measured), $"capture {truth["index"]}");
                Assert.That(hand.TrackId, Is.EqualTo(1), "one hand, one track");
                Assert.That(hand.SigmaMm, Is.LessThanOrEqualTo(20), $"capture {truth["index"]}: known well enough to be stated");
            });
            Assert.That(captures, Is.GreaterThan(0));
            Assert.That(lost, Is.EqualTo(2), "captures with lost depth");
        }

        /// <summary>These recordings' infrared shows no hand that the model knows: depth must stand.</summary>
        [TestCase("rec_hand_nfov", "lite")]
        [TestCase("rec_hand_binned", "full")]
        public void LandmarkHandTracker_OnARecording_PalmStaysWithinFifteenMillimetres(string name, string model)
        {
            using HandLandmarkNetwork network = HandModelForTests.Open(model);
            int captures = 0, seen = 0;
            LandmarkHandTracker? tracker = null;
            Run(name, camera => tracker = new LandmarkHandTracker(new DepthHandTracker(camera), camera, network), (truth, hands) =>
            {
                captures++;
                Assert.That(hands.Hands.Length, Is.EqualTo(1), $"capture {truth["index"]}");
                Assert.That((hands.Hands[0].PalmMm - Point(truth["palm_centre_mm"]!)).Length, Is.LessThan(15), $"capture {truth["index"]}");
                seen += tracker!.TryGetLandmarks(1, out _) ? 1 : 0;
            });
            TestContext.Out.WriteLine($"{name}, {model}: landmarks in {seen} of {captures} captures");
            Assert.That(captures, Is.GreaterThan(0));
        }

        [TestCase("rec_hand_nfov")]
        [TestCase("rec_hand_binned")]
        public void PublishedHandTracker_OnARecording_SeesTheMovingHandFromTheSecondCapture(string name)
        {
            int index = 0;
            Run(name, camera => new PublishedHandTracker(camera), (truth, hands) =>
            {
                Assert.That(hands.Hands.Length, Is.EqualTo(index++ == 0 ? 0 : 1), $"capture {truth["index"]}");
                if (hands.Hands.Length == 1)
                {
                    // The middle of what moves is somewhere on hand and forearm, 0.37 m together.
                    Assert.That((hands.Hands[0].PalmMm - Point(truth["palm_centre_mm"]!)).Length, Is.LessThan(250));
                }
            });
        }

        private static void Run(string name, System.Func<PinholeCamera, IHandTracker> create, System.Action<JToken, HandObservations> check)
        {
            string recording = TestFiles.Reference("k4a", name + ".mkv");
            JObject truth = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", name + ".truth.json")));
            JObject reference = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", name + ".reference.json")));
            double[] c = reference["calibration"]!["depth"]!.Select(v => (double)v).ToArray();
            var camera = new PinholeCamera(c[2], c[3], c[0], c[1], (int)truth["depth"]!["width"]!, (int)truth["depth"]!["height"]!);
            IHandTracker tracker = create(camera);
            var hands = new HandObservations();
            using var frame = new Frame();
            using var source = new KinectRecordingSource(KinectRecording.Open(recording), KinectStreams.Depth | KinectStreams.Infrared);
            while (source.TryRead(frame))
            {
                tracker.Process(frame, hands);
                if (frame.Depth.IsPresent)
                    check(truth["frames"]!.Single(f => (long?)f["depth_ts_usec"] == frame.Depth.TimeUs), hands);
            }
        }

        private static Vector3D Point(JToken mm) => new((double)mm[0]!, (double)mm[1]!, (double)mm[2]!);
    }
}
