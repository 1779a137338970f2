using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using LaserTracking.Tracking;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>The recording whose capture 15 holds an infrared picture with the dot in it, laid on colour by the device's calibration.</summary>
    [Category("Reference")]
    public sealed class RecordedDualTests
    {
        [Test]
        public void DualShotDetector_LaserRecording_FindsTheFourShotsOnceEach()
        {
            JObject truth = JObject.Parse(System.IO.File.ReadAllText(TestFiles.Reference("k4a", "rec_laser_720p_mjpg.truth.json")));
            using var source = new KinectRecordingSource(KinectRecording.Open(TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv")), KinectStreams.Color | KinectStreams.Infrared);
            Assert.That(source.Recording.TryReadCalibration(out byte[] json), Is.True);
            KinectRecordConfiguration configuration = source.Recording.Configuration;
            Assert.That(KinectCalibration.TryRead(json, configuration.DepthMode, configuration.ColorWidth, configuration.ColorHeight, out KinectCalibration? kinect, out string reason), Is.True, reason);

            // The recording's depth plane lies at 3 m.
            var detector = new DualShotDetector(null, InfraredMapping.OfCameras(kinect!.Infrared, kinect.Color, kinect.InfraredToColorMm, 3000));
            var tracker = new ShotTracker();
            var detections = new Detections();
            var shots = new List<Shot>();
            int infraredFrames = 0;
            using var frame = new Frame();
            while (source.TryRead(frame))
            {
                infraredFrames += frame.Infrared.IsPresent ? 1 : 0;
                detector.Process(frame, detections);
                tracker.Process(detections);
                shots.AddRange(tracker.Shots.ToArray());
                if (frame.Index == 15)
                {
                    JToken dot = truth["frames"]![15]!["dots"]![0]!;
                    Assert.That(detections.Dots.Length, Is.EqualTo(1), "one dot from two pictures");
                    Assert.That((detections.Dots[0].PositionPx - new Vector2D((double)dot["x"]!, (double)dot["y"]!)).Length, Is.LessThan(0.3));
                }
            }

            Assert.That(infraredFrames, Is.EqualTo(2));
            Assert.That(shots.Count, Is.EqualTo(((JArray)truth["shots"]!).Count));
            Assert.That(shots.TrueForAll(shot => shot.Dot.Color == LaserColor.Green), Is.True);
        }
    }
}
