using System;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>replay --rendered: a simulated session written as two videos whose clocks differ.</summary>
    public sealed class ReplayRenderedTests
    {
        private const int SkippedPictures = 75;
        private TemporaryFolder _folder = null!;
        private SimulatedRange _range = null!;

        [OneTimeSetUp]
        public void MakeVideos()
        {
            _folder = new TemporaryFolder();
            _range = new SimulatedRange(Scenario(1), SimulationScenes.Empty());
            RangeCalibrationFile.Write(_range.Calibration, _folder.File("screen.json"));
            Encode(_range.CreateColorSource(), 30, 0, "camera.mkv");
            Encode(_range.CreatePictureSource(), 60, SkippedPictures, "pictures.mkv");
            Encode(new SimulatedRange(Scenario(2), SimulationScenes.Empty()).CreatePictureSource(), 60, 0, "others.mkv");
        }

        [OneTimeTearDown]
        public void Clean() => _folder.Dispose();

        [Test]
        public void Replay_RenderedVideoOnAnotherClock_IsUsedAndItsDelayFound()
        {
            string[] lines = Replay("pictures.mkv");
            Assert.That(lines.Where(l => l.Contains("\"kind\":\"rendered\"")).First(), Does.Contain("are found in the camera"));

            // A held laser is one shot, though everything moves; each of the others is found as well.
            int after = _range.Truth.Shots.Count(s => s.SceneTimeUs > 3_500_000);
            Assert.That(lines.Count(l => l.StartsWith("{\"type\":\"shot\"", StringComparison.Ordinal) && FrameOf(l) > 100), Is.EqualTo(after));
        }

        [Test]
        public void Replay_VideoOfOtherPictures_SaysSoAndGoesOnWithout()
        {
            string[] lines = Replay("others.mkv");
            Assert.That(lines.Count(l => l.Contains("\"kind\":\"input\"") && l.Contains("does not fit the pictures")), Is.EqualTo(1));
            Assert.That(lines, Has.None.Contains("\"kind\":\"rendered\""));
            Assert.That(lines.Last(), Does.Contain("\"type\":\"end\""));
        }

        [Test]
        public void Replay_RenderedWithoutCalibration_IsRefused() =>
            CommandLine.AssertRefused("add --calibration", "replay", _folder.File("camera.mkv"), "--rendered", _folder.File("pictures.mkv"));

        [Test]
        public void Replay_RenderedVideoThatIsNone_IsRefused()
        {
            File.WriteAllText(_folder.File("text.mp4"), "no video");
            CommandLine.AssertRefused("text.mp4", "replay", _folder.File("camera.mkv"), "--calibration", _folder.File("screen.json"), "--rendered", _folder.File("text.mp4"));
            CommandLine.AssertRefused("does not exist", "replay", _folder.File("camera.mkv"), "--calibration", _folder.File("screen.json"), "--rendered", _folder.File("none.mp4"));
        }

        private static SimulationScenario Scenario(int seed)
        {
            var scenario = new SimulationScenario { Seed = seed, DurationS = 8 };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Width = scenario.Projector.Width = 320;
            scenario.ColorCamera.Height = scenario.Projector.Height = 180;
            scenario.Projector.Content = ProjectedContent.Shapes;
            for (int i = 0; i < 2; i++)
            {
                scenario.Shooters.Add(new ShooterSettings());
                scenario.Shooters[i].Laser.DotRadiusMm = 8;
            }

            scenario.Shots.Add(new ShotSettings { TimeS = 4, PulseMs = 3000, Shooter = 1, ScreenM = new Vector2D(1.2, 0.9) });
            for (int i = 0; i < 5; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 4.2 + 0.6 * i, PulseMs = 50, Shooter = 2, ScreenM = new Vector2D(0.5 + 0.5 * i, 0.4) });
            return scenario;
        }

        private static int FrameOf(string line) => (int)Newtonsoft.Json.Linq.JObject.Parse(line)["frame"]!;

        private string[] Replay(string rendered)
        {
            string events = _folder.File(rendered + ".jsonl");
            (int exitCode, _, string error) = CommandLine.Run("replay", _folder.File("camera.mkv"), "--calibration", _folder.File("screen.json"), "--rendered", _folder.File(rendered), "--events", events);
            Assert.That(exitCode, Is.EqualTo(0), error);
            return File.ReadAllLines(events);
        }

        private void Encode(IFrameSource source, int framesPerSecond, int skip, string name)
        {
            string raw = _folder.File(name + ".bgra");
            using (source)
            using (var frame = new Frame())
            using (FileStream file = File.Create(raw))
            {
                while (source.TryRead(frame))
                {
                    if (frame.Index >= skip)
                        file.Write(frame.Color.Bytes);
                }
            }

            FfmpegForTests.Run("-f", "rawvideo", "-pixel_format", "bgra", "-video_size", "320x180", "-framerate", framesPerSecond.ToString(System.Globalization.CultureInfo.InvariantCulture), "-i", raw, "-c:v", "ffv1", _folder.File(name));
            File.Delete(raw);
        }
    }
}
