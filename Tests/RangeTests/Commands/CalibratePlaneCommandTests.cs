using System;
using System.IO;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using LaserTracking.Host;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    public sealed class CalibratePlaneCommandTests
    {
        [Test]
        [Category("Reference")]
        public void Plane_BySizeAndByDepth_Agree()
        {
            string recording = TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv");
            using var folder = new TemporaryFolder();
            string file = Write(folder, recording, new Vector2D(2.0, 1.2));
            JObject result = Run(0, "calibrate", "plane", file, "--depth", recording, "--limit", "10");
            Assert.That((double)result["from_size"]!["corner_rms_px"]!, Is.LessThan(1e-3));
            Assert.That((double)result["from_depth"]!["sigma_mm"]!, Is.InRange(0, 10));
            Assert.That((double)result["agreement"]!["angle_deg"]!, Is.LessThan(0.05));
            Assert.That(Math.Abs((double)result["agreement"]!["middle_mm"]!), Is.LessThan(1));
            Assert.That((double)result["agreement"]!["screen_m_by_depth"]![0]!, Is.EqualTo(2.0).Within(2e-3));
            TestContext.Out.WriteLine(result.ToString(Newtonsoft.Json.Formatting.None));
        }

        [Test]
        [Category("Reference")]
        public void Plane_WrongSize_FailsTheLimit()
        {
            string recording = TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv");
            using var folder = new TemporaryFolder();
            JObject result = Run(1, "calibrate", "plane", Write(folder, recording, new Vector2D(2.1, 1.26)), "--depth", recording, "--limit", "20");
            Assert.That((double)result["agreement"]!["screen_m_by_depth"]![0]!, Is.EqualTo(2.0).Within(2e-3));
        }

        [Test]
        public void Plane_WithoutACamera_IsRefused()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json");
            var screen = new ScreenGeometry(new Homography(new[] { 0.003, 0.0001, -0.4, 0.0002, 0.003, -0.3, 1e-5, 2e-5, 1 }), new Vector2D(3.73, 2.26));
            RangeCalibrationFile.Write(new RangeCalibration(screen, 1280, 720, null), file);
            CommandLine.AssertRefused("does not hold the camera's lens", "calibrate", "plane", file);
            CommandLine.AssertRefused("nothing to compare", "calibrate", "plane", file, "--limit", "5");
            CommandLine.AssertRefused("no such file", "calibrate", "plane", folder.File("none.json"));
        }

        /// <summary>A screen on the plane that the recording's depth camera saw 3 m away.</summary>
        private static string Write(TemporaryFolder folder, string recordingFile, Vector2D statedSizeM)
        {
            using KinectRecording recording = KinectRecording.Open(recordingFile);
            Assert.That(recording.TryReadCalibration(out byte[] json), Is.True);
            Assert.That(KinectCalibration.TryRead(json, recording.Configuration.DepthMode, 1280, 720, out KinectCalibration? kinect, out string reason), Is.True, reason);
            var corners = new Vector2D[4];
            Vector2D[] onScreen = ScreenGeometry.CornersOf(new Vector2D(2000, 1200));
            for (int i = 0; i < 4; i++)
            {
                Vector3D point = kinect!.InfraredToColorMm.TransformPoint(new Vector3D(onScreen[i].X - 1000, onScreen[i].Y - 700, 3000));
                Assert.That(kinect.Color.TryProject(point, out corners[i]), Is.True);
            }

            Assert.That(ScreenGeometry.TryFit(corners, ScreenGeometry.CornersOf(statedSizeM), statedSizeM, kinect!.Color, 0.1, out ScreenGeometry? screen, out reason), Is.True, reason);
            string file = folder.File("screen.json");
            RangeCalibrationFile.Write(new RangeCalibration(screen!, 1280, 720, null), file);
            return file;
        }

        private static JObject Run(int exitCode, params string[] arguments)
        {
            (int code, string output, string errors) = CommandLine.Run(arguments);
            Assert.That(code, Is.EqualTo(exitCode), errors);
            return JObject.Parse(output);
        }
    }
}
