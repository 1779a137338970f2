using System;
using System.IO;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using LaserTracking.Host;
using LaserTracking.Simulation;
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

        /// <summary>The recordings of hands show a wall behind them: a screen on that wall, with hand and forearm before it.</summary>
        [TestCase("rec_laser_720p_mjpg")]
        [TestCase("rec_hand_nfov")]
        [TestCase("rec_hand_binned")]
        [Category("Reference")]
        public void Plane_EveryRecordingWithAWall_MeasuresItWhereItWasDrawn(string name)
        {
            string recordingFile = TestFiles.Reference("k4a", name + ".mkv");
            JObject truth = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", name + ".truth.json")));
            double wallMm = (double)(truth["wall_depth_mm"] ?? truth["depth_plane_mm"])!;
            using var folder = new TemporaryFolder();
            string file = Write(folder, recordingFile, new Vector2D(2.0, 1.2), wallMm);
            JObject result = Run(0, "calibrate", "plane", file, "--depth", recordingFile, "--limit", "10");
            TestContext.Out.WriteLine(name + " " + result["from_depth"]!.ToString(Newtonsoft.Json.Formatting.None) + " " + result["agreement"]!.ToString(Newtonsoft.Json.Formatting.None));
            KinectCalibration kinect = Kinect(recordingFile);
            Vector3D normal = kinect.InfraredToColorMm.TransformDirection(new Vector3D(0, 0, 1));
            var expected = new Plane3D(normal, kinect.InfraredToColorMm.TransformPoint(new Vector3D(0, 0, wallMm)));
            double[] found = result["from_depth"]!["normal"]!.ToObject<double[]>()!;
            double angle = Math.Acos(Math.Min(1, Math.Abs(Vector3D.Dot(normal, new Vector3D(found[0], found[1], found[2]).Normalized))));
            Assert.That(angle * 180 / Math.PI, Is.LessThan(0.05));
            Assert.That((double)result["from_depth"]!["distance_mm"]!, Is.EqualTo(Math.Abs(expected.Distance)).Within(1));
            Assert.That((double)result["agreement"]!["worst_corner_mm"]!, Is.LessThan(3));
        }

        [Test]
        public void Plane_SimulatedRoom_DepthAgreesWithTheCalibratedScreen()
        {
            using var folder = new TemporaryFolder();
            string scenario = folder.File("room.json"), file = folder.File("screen.json");
            var room = new SimulationScenario { Name = "plane", Seed = 3, DurationS = 0.27 };
            (room.ColorCamera.Width, room.ColorCamera.Height, room.ColorCamera.FieldOfViewDeg) = (640, 360, 80);
            (room.ColorCamera.PositionM, room.ColorCamera.LookAtM) = (new Vector3D(2.4, 0.6, -2.8), new Vector2D(1.87, 1.13));
            (room.ColorCamera.LensK1, room.ColorCamera.LensK2) = (-0.1, 0.02);
            (room.DepthCamera.PositionM, room.DepthCamera.LookAtM) = (new Vector3D(2.43, 0.6, -2.8), new Vector3D(1.87, 1.13, 0));
            (room.Projector.Content, room.Projector.PatternHoldMs) = (ProjectedContent.Calibration, 66.7);
            File.WriteAllText(scenario, SimulationScenarioFile.ToJson(room));
            Run(0, "calibrate", "screen", "--image", scenario, "--size", "3.73x2.26", "--out", file);
            CommandLine.AssertRefused("does not show the focal length", "calibrate", "plane", file);
            JObject result = Run(0, "calibrate", "plane", file, "--depth", scenario, "--limit", "20");
            TestContext.Out.WriteLine(result.ToString(Newtonsoft.Json.Formatting.None));

            // The simulated sensor errs by a wave of 5 mm over the distance, as the real one does.
            Assert.That((double)result["agreement"]!["angle_deg"]!, Is.LessThan(0.3));
            Assert.That(Math.Abs((double)result["agreement"]!["middle_mm"]!), Is.LessThan(8));
            Assert.That((double)result["from_size"]!["distance_mm"]!, Is.EqualTo(2800).Within(3));
            room.DepthCamera.Enabled = false;
            File.WriteAllText(scenario, SimulationScenarioFile.ToJson(room));
            CommandLine.AssertRefused("there is no depth", "calibrate", "plane", file, "--depth", scenario);
        }

        /// <summary>That recording's picture was drawn without its depth: no flat screen looks like the drawn one from before the depth plane.</summary>
        [Test]
        [Category("Reference")]
        public void Plane_DrawnScreenThatIsNone_IsSaidToMissItsCorners()
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json");
            Run(0, "calibrate", "screen", "--corners", "150,82", "1138,104", "1110,640", "182,622", "--size", "2.0x1.2", "--image-size", "1280x720", "--out", file);
            (int code, _, string error) = CommandLine.Run("calibrate", "plane", file, "--depth", TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv"), "--limit", "20");
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("its corners miss by 16.1 px").And.Contain("disagree by"));
        }

        [TestCase("1280", ExitCodes.CheckFailed, "its corners miss by")]
        [TestCase("640", ExitCodes.BadInput, "calibrated for pictures of 640x720, the screen for 1280x720")]
        public void Plane_ScreenThatIsNoRectangleToThatCamera_FailsAlsoWithoutALimit(string width, int expected, string words)
        {
            using var folder = new TemporaryFolder();
            string file = folder.File("screen.json"), camera = folder.File("camera.json");
            Run(0, "calibrate", "screen", "--corners", "150,82", "1138,104", "1110,640", "182,622", "--size", "2.0x1.2", "--out", file);
            File.WriteAllText(camera, $"{{\"v\":1,\"kind\":\"camera\",\"image_size\":[{width},720],\"K\":[[900,0,640],[0,900,360],[0,0,1]],\"dist\":[0,0,0,0,0]}}");
            (int code, _, string error) = CommandLine.Run("calibrate", "plane", file, "--camera", camera);
            Assert.That(code, Is.EqualTo(expected), error);
            Assert.That(error, Does.Match("^range: [^\n]+\n$").And.Contain(words));
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

        /// <summary>A screen on the wall that the recording's depth camera saw squarely before it.</summary>
        private static string Write(TemporaryFolder folder, string recordingFile, Vector2D statedSizeM, double wallMm = 3000)
        {
            KinectCalibration kinect = Kinect(recordingFile);
            var corners = new Vector2D[4];
            Vector2D[] onScreen = ScreenGeometry.CornersOf(new Vector2D(2000, 1200));
            for (int i = 0; i < 4; i++)
            {
                Vector3D point = kinect.InfraredToColorMm.TransformPoint(new Vector3D(onScreen[i].X - 1000, onScreen[i].Y - 700, wallMm));
                Assert.That(kinect.Color.TryProject(point, out corners[i]), Is.True);
            }

            Assert.That(ScreenGeometry.TryFit(corners, ScreenGeometry.CornersOf(statedSizeM), statedSizeM, kinect.Color, 0.1, out ScreenGeometry? screen, out string reason), Is.True, reason);
            string file = folder.File("screen.json");
            RangeCalibrationFile.Write(new RangeCalibration(screen!, 1280, 720, null), file);
            return file;
        }

        private static KinectCalibration Kinect(string recordingFile)
        {
            using KinectRecording recording = KinectRecording.Open(recordingFile);
            Assert.That(recording.TryReadCalibration(out byte[] json), Is.True);
            Assert.That(KinectCalibration.TryRead(json, recording.Configuration.DepthMode, 1280, 720, out KinectCalibration? kinect, out string reason), Is.True, reason);
            return kinect!;
        }

        private static JObject Run(int exitCode, params string[] arguments)
        {
            (int code, string output, string errors) = CommandLine.Run(arguments);
            Assert.That(code, Is.EqualTo(exitCode), errors);
            return JObject.Parse(output);
        }
    }
}
