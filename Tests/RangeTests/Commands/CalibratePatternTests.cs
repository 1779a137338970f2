using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host;
using LaserTracking.Simulation;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>The automatic calibration from end to end: pictures out, pictures in, calibration out.</summary>
    public sealed class CalibratePatternTests
    {
        [Test]
        public void Pattern_ItsOwnPicturesAsCamera_GiveTheExactMapping()
        {
            NeedFfmpeg();
            using var folder = new TemporaryFolder();
            string pattern = folder.File("pattern"), result = folder.File("screen.json"), map = folder.File("map.png");
            Assert.That(CommandLine.Run("calibrate", "pattern", "--out", pattern, "--size", "960x540").ExitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(Directory.GetFiles(pattern).Select(Path.GetFileName), Is.EquivalentTo(new[] { "pattern-1.png", "pattern-2.png", "pattern-3.png", "pattern-4.png", "show.html" }));
            (int code, string output, string error) = CommandLine.Run(["calibrate", "screen", "--size", "3.2x1.8", "--out", result, "--map", map, "--image", .. Pictures(pattern)]);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            JObject printed = JObject.Parse(output);
            Assert.That(((int)printed["fit_points"]!, (int)printed["verify"]!["n"]!, ((JArray)printed["regions"]!).Count), Is.EqualTo((120, 144, 9)));
            Assert.That(File.ReadAllBytes(map).Take(4), Is.EqualTo(new byte[] { 0x89, 0x50, 0x4E, 0x47 }));

            // A pixel's centre lies half a pixel right of and below its corner.
            ScreenGeometry screen = RangeCalibrationFile.Read(result).Screen;
            foreach (Vector2D px in new[] { new Vector2D(0, 0), new Vector2D(959, 539), new Vector2D(480, 100) })
                Assert.That((screen.ToScreenM(px) - new Vector2D((px.X + 0.5) / 300, (px.Y + 0.5) / 300)).Length * 1000, Is.LessThan(0.02));
            Assert.That(CommandLine.Run("calibrate", "verify", result, "--image", pattern).ExitCode, Is.EqualTo(ExitCodes.Done));

            // Of a screen twice as high the same calibration is wrong by far.
            File.WriteAllText(result, File.ReadAllText(result).Replace("1.8", "3.6"));
            (code, output, error) = CommandLine.Run("calibrate", "verify", result, "--image", pattern);
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("over the limit of 5 mm"));
        }

        [Test]
        public void Screen_SinglePicture_IsProvenWithPartOfItself()
        {
            NeedFfmpeg();
            using var folder = new TemporaryFolder();
            CommandLine.Run("calibrate", "pattern", "--out", folder.Path, "--size", "800x600");
            (int code, string output, string error) = CommandLine.Run("calibrate", "screen", "--size", "2x1.5", "--out", folder.File("screen.json"), "--image", folder.File("pattern-3.png"));
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That(error, Does.Contain("only one of the two boards was seen"));
            Assert.That((double)JObject.Parse(output)["verify"]!["max_mm"]!, Is.LessThan(0.1));
        }

        [Test]
        public void Screen_SimulatedRoom_IsCalibratedWithItsLens()
        {
            using var folder = new TemporaryFolder();
            string scenario = folder.File("room.json"), result = folder.File("screen.json");
            File.WriteAllText(scenario, SimulationScenarioFile.ToJson(Room()));
            (int code, string output, string error) = CommandLine.Run("calibrate", "screen", "--size", "3.73x2.26", "--out", result, "--image", scenario);
            Assert.That(code, Is.EqualTo(ExitCodes.Done), error);
            Assert.That((bool)JObject.Parse(output)["lens_found"]!, Is.True);
            RangeCalibration calibration = RangeCalibrationFile.Read(result);
            Assert.That(calibration.Screen.Camera, Is.Not.Null);
            Assert.That((calibration.ImageWidth, calibration.ImageHeight), Is.EqualTo((640, 360)));
        }

        [Test]
        public void Screen_CameraBumpedMeanwhile_IsRefusedAndWritesNothing()
        {
            using var folder = new TemporaryFolder();
            string scenario = folder.File("room.json"), result = folder.File("screen.json");
            SimulationScenario room = Room();
            room.Nudges.Add(new NudgeSettings { TimeS = 0.3, ShiftPx = new Vector2D(5, 0) });
            File.WriteAllText(scenario, SimulationScenarioFile.ToJson(room));
            (int code, string output, string error) = CommandLine.Run("calibrate", "screen", "--size", "3.73x2.26", "--out", result, "--image", scenario);
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("moved during the capture").And.Contain("nothing was written"));
            Assert.That((bool)JObject.Parse(output)["accepted"]!, Is.False);
            Assert.That(File.Exists(result), Is.False);
        }

        [Test]
        public void Screen_PicturesOfSomethingElse_AreRefused()
        {
            using var folder = new TemporaryFolder();
            string scenario = folder.File("room.json");
            SimulationScenario room = Room();
            room.Projector.Content = ProjectedContent.Bay;
            File.WriteAllText(scenario, SimulationScenarioFile.ToJson(room));
            (int code, _, string error) = CommandLine.Run("calibrate", "screen", "--size", "3.73x2.26", "--out", folder.File("screen.json"), "--image", scenario);
            Assert.That(code, Is.EqualTo(ExitCodes.CheckFailed));
            Assert.That(error, Does.Contain("no projected pattern was recognised"));
        }

        [TestCase("does not exist", "--image", "missing.png")]
        [TestCase("points given in several ways", "--image", "a.png", "--corners", "1,1", "9,1", "9,9", "1,9")]
        [TestCase("no points given")]
        [TestCase("there is a map of the pattern's points only", "--map", "m.png", "--corners", "150,82", "1138,104", "1110,640", "182,622")]
        [TestCase("the calibration has no date", "--history", "h", "--corners", "150,82", "1138,104", "1110,640", "182,622")]
        [TestCase("is no date", "--date", "yesterday", "--corners", "150,82", "1138,104", "1110,640", "182,622")]
        public void Screen_ImpossibleOptions_AreRefused(string words, params string[] options)
        {
            using var folder = new TemporaryFolder();
            options = options.Select(o => o == "m.png" ? folder.File(o) : o).ToArray();
            CommandLine.AssertRefused(words, ["calibrate", "screen", "--size", "3x2", "--out", folder.File("screen.json"), .. options]);
            Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        }

        [TestCase("100x100")]
        [TestCase("1920x100")]
        [TestCase("99999x56000")]
        public void Pattern_ImpossibleSize_IsRefused(string size)
        {
            using var folder = new TemporaryFolder();
            CommandLine.AssertRefused("--size", "calibrate", "pattern", "--out", folder.Path, "--size", size);
            Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        }

        /// <summary>PNG pictures are read by it.</summary>
        private static void NeedFfmpeg()
        {
            if (Prerequisites.Locate("ffmpeg") == null)
                Assert.Ignore("ffmpeg is not installed");
        }

        private static string[] Pictures(string folder) => Enumerable.Range(1, 4).Select(i => Path.Combine(folder, $"pattern-{i}.png")).ToArray();

        private static SimulationScenario Room()
        {
            var scenario = new SimulationScenario { Seed = 2, DurationS = 0.5 };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.ColorCamera.LensK1 = -0.1;
            scenario.Projector.Width = 640;
            scenario.Projector.Height = 360;
            scenario.Projector.Content = ProjectedContent.Calibration;
            scenario.Projector.PatternHoldMs = 120;
            return scenario;
        }
    }
}
