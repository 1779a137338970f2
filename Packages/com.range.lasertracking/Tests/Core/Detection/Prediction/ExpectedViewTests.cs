using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Rendered pictures known: what is measured and learned, what is found, and when it is not relied on.</summary>
    public sealed class ExpectedViewTests
    {
        private const int FramesPerSecond = 30;

        [TestCase(1, 20)]
        [TestCase(2, 47)]
        [TestCase(3, 90)]
        [Category("Long")]
        public void Delay_UnderMovingShapes_IsMeasuredWithinFiveMilliseconds(int seed, double delayMs)
        {
            SimulationScenario scenario = MovingRange.Scenario(seed, 3);
            scenario.Projector.DelayMs = delayMs;
            var range = new MovingRange(scenario);
            range.Play();
            foreach (long? delayUs in range.DelaysUs.Skip(FramesPerSecond))
                Assert.That(delayUs, Is.EqualTo(delayMs * 1000).Within(5000));
        }

        [Test]
        [Category("Long")]
        public void Delay_OfClocksThatDriftApart_IsFollowed()
        {
            SimulationScenario scenario = MovingRange.Scenario(4, 10);
            scenario.Projector.DelayMs = 60;

            // From 3 s to 7 s the clock of drawing gains 10 ms a second: the delay it measures by shrinks by 40 ms.
            var range = new MovingRange(scenario) { ClockOffsetUs = timeUs => Math.Max(0, Math.Min(4_000_000, timeUs - 3_000_000)) / 100 };
            range.Play();
            Assert.That(range.DelaysUs[3 * FramesPerSecond], Is.EqualTo(60_000).Within(5000));
            Assert.That(range.DelaysUs[range.DelaysUs.Count - 1], Is.EqualTo(20_000).Within(5000));
        }

        [Test]
        [Category("Long")]
        public void Delay_ThatJumps_IsFoundAnewWithinThreeSeconds()
        {
            SimulationScenario scenario = MovingRange.Scenario(5, 9);
            scenario.Projector.DelayMs = 150;
            var range = new MovingRange(scenario) { ClockOffsetUs = timeUs => timeUs < 3_000_000 ? 0 : 100_000 };
            range.Play();
            Assert.That(range.DelaysUs[2 * FramesPerSecond], Is.EqualTo(150_000).Within(5000));
            for (int frame = 6 * FramesPerSecond; frame < range.DelaysUs.Count; frame++)
                Assert.That(range.DelaysUs[frame], Is.EqualTo(50_000).Within(5000), "frame " + frame);
        }

        [Test]
        [Category("Long")]
        public unsafe void Colors_OnceLearned_ExpectTheCameraToSeeALittleLessEverywhere()
        {
            SimulationScenario scenario = MovingRange.Scenario(6, 4);
            scenario.Room.Ambient = 0.1;
            scenario.ColorCamera.Gain = 1.3;
            var range = new MovingRange(scenario);
            int brighter = 0, pixels = 0;
            double room = 0;
            range.Play(after: (frame, _) =>
            {
                if (frame.Index < 3 * FramesPerSecond)
                    return;
                Assert.That(range.Expected.State, Is.EqualTo(PredictionState.Trusted));
                range.Expected.CopyExpected(0, 0, 319, 179);
                for (int i = 0; i < 320 * 180; i++)
                {
                    // Beside the screen white is expected: anything may be there.
                    if ((range.Expected.Picture[i] & 0xFFFFFF) == 0xFFFFFF)
                        continue;
                    int now = (int)(((uint*)frame.Color.Pixels)[i] >> 8 & 255), expected = (int)(range.Expected.Picture[i] >> 8 & 255);
                    brighter += now > expected + 10 ? 1 : 0;
                    room += Math.Max(0, expected - now);
                    pixels++;
                }
            });

            Assert.That(brighter, Is.LessThan(pixels / 2000));
            Assert.That(room / pixels, Is.LessThan(45));
        }

        [Test]
        [Category("Long")]
        public void Dot_ThatRestsAMinuteWhileEverythingMoves_IsOneShotAndStaysADot()
        {
            SimulationScenario scenario = MovingRange.Scenario(7, 63);
            scenario.Shots.Add(new ShotSettings { TimeS = 2.5, PulseMs = 60_000, ScreenM = new Vector2D(1.4, 0.8) });
            var range = new MovingRange(scenario);
            range.PlayAndCount(true, out int shown, out int seen);
            Assert.That(range.Shots.Count(s => s.FirstFrameIndex > 2 * FramesPerSecond), Is.EqualTo(1));
            Assert.That(shown, Is.GreaterThan(1790));
            Assert.That(seen, Is.GreaterThanOrEqualTo(0.99 * shown));
        }

        [Test]
        [Category("Long")]
        public void Shots_WhileEverythingMoves_AreFoundWithTheirColorInTheirFirstFrame()
        {
            SimulationScenario scenario = MovingRange.Scenario(8, 14);
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shooters[1].Laser.DotRadiusMm = 8;
            scenario.Shooters[1].Laser.Color = LaserColor.Red;
            for (int i = 0; i < 22; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 2 + 0.52 * i, Shooter = 1 + i % 2, PulseMs = 50, ScreenM = new Vector2D(0.4 + 0.11 * i, 0.3 + 0.17 * (i % 8)) });
            var range = new MovingRange(scenario);
            range.Play();
            Assert.That(range.Shots.Count, Is.EqualTo(22));
            for (int i = 0; i < 22; i++)
            {
                TrueShot truth = range.Truth.Shots[i];
                Assert.That(range.Shots[i].FirstFrameIndex, Is.InRange(truth.FirstFrame, truth.FirstFrame + 1), "shot " + i);
                Assert.That((range.Shots[i].Dot.PositionPx - truth.FirstLightPx).Length, Is.LessThan(2), "shot " + i);
                Assert.That(range.Shots[i].Dot.Color, Is.EqualTo(truth.Color).Or.EqualTo(LaserColor.Unknown), "shot " + i);
            }
        }

        [TestCase(ProjectedContent.Shapes)]
        [TestCase(ProjectedContent.ShapesOverTexture)]
        [Category("Long")]
        public void Shots_OfNobody_AreNone(ProjectedContent content)
        {
            var range = new MovingRange(MovingRange.Scenario(9, 20, content));
            range.Play();
            Assert.That(range.States.Skip(2 * FramesPerSecond), Is.All.EqualTo(PredictionState.Trusted));
            Assert.That(range.Shots.Where(s => s.FirstFrameIndex > 2 * FramesPerSecond).Select(s => s.FirstFrameIndex + " at " + s.Dot.PositionPx + " area " + s.Dot.AreaPx + " peak " + s.Dot.Peak), Is.Empty);
        }

        [TestCase(20, 0.5)]
        [TestCase(21, 0.8)]
        [Category("Long")]
        public void Picture_OnSomebodyBeforeTheScreen_IsNoShotAndShotsBesideThemAreFound(int seed, double reflectance)
        {
            SimulationScenario scenario = MovingRange.Scenario(seed, 14);
            scenario.Room.Obstacles.Add(new ObstacleSettings { TopM = new Vector2D(1.2, 1.0), WidthM = 0.45, Reflectance = reflectance });
            for (int i = 0; i < 20; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 3 + 0.52 * i, PulseMs = 50, ScreenM = new Vector2D(0.3 + 0.13 * i, 0.2 + 0.15 * (i % 4)) });
            var range = new MovingRange(scenario);
            range.Play();
            Assert.That(range.States.Skip(3 * FramesPerSecond).Count(s => s == PredictionState.Trusted), Is.GreaterThan(10 * FramesPerSecond));
            Assert.That(range.Shots.Count(s => s.FirstFrameIndex > 3 * FramesPerSecond - 3), Is.EqualTo(20));
        }

        [Test]
        [Category("Long")]
        public void Pictures_FinerThanTheCameraSeesThem_AreReliedOnAllTheSame()
        {
            SimulationScenario scenario = MovingRange.Scenario(22, 4);
            scenario.Projector.Width = 640;
            scenario.Projector.Height = 360;
            var range = new MovingRange(scenario);
            range.Play();
            Assert.That(range.States.Skip(2 * FramesPerSecond), Is.All.EqualTo(PredictionState.Trusted));
        }

        [Test]
        [Category("Long")]
        public void Pictures_ThatTheProjectorDoesNotShow_ChangeNothing()
        {
            SimulationScenario scenario = MovingRange.Scenario(10, 6);
            for (int i = 0; i < 8; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 1 + 0.6 * i, PulseMs = 50, ScreenM = new Vector2D(0.4 + 0.3 * i, 0.8) });
            var wrong = new MovingRange(scenario, MovingRange.Scenario(77, 6));
            wrong.Play();
            Assert.That(wrong.States, Has.None.EqualTo(PredictionState.Trusted));
            var without = new MovingRange(scenario);
            without.Play(useExpected: false);
            Assert.That(Frames(wrong.Shots), Is.EqualTo(Frames(without.Shots)));
        }

        [Test]
        public void Pictures_ThatDoNotMove_LeaveTheDelayUnknown()
        {
            var range = new MovingRange(MovingRange.Scenario(11, 2, ProjectedContent.Bay));
            range.Play();
            Assert.That(range.States.Skip(5), Is.All.EqualTo(PredictionState.Searching));
        }

        [Test]
        public void Frames_OfAnotherSizeThanCalibrated_SwitchItOff()
        {
            var history = new RenderedFrameHistory();
            using var picture = new Frame();
            new FrameBuilder(64, 36).Wall(50, 50, 50).Write(picture, 0, 0);
            history.Add(picture.Color, 0);
            var range = new MovingRange(MovingRange.Scenario(1, 1));
            var run = new DetectionRun(new ShotDetector(null, new ExpectedView(history, range.Calibration)), 160, 90);
            run.Play(0, 5, (b, i) => b.Wall(50, 50, 50));
            Assert.That(run.Detections.Prediction, Is.EqualTo(PredictionState.Off));
        }

        [Test]
        public void Process_OnceWarm_AllocatesNothing()
        {
            SimulationScenario scenario = MovingRange.Scenario(12, 2.5);
            scenario.Shots.Add(new ShotSettings { TimeS = 1, PulseMs = 1000, ScreenM = new Vector2D(1.4, 0.8) });
            var range = new MovingRange(scenario);
            var history = new RenderedFrameHistory();
            var detector = new ShotDetector(null, new ExpectedView(history, range.Calibration));
            var detections = new Detections();
            Frame[] frames = ReadAll(range.CreateCamera()), pictures = ReadAll(range.CreatePictures());
            int trusted = 0;
            void Round()
            {
                int next = 0;
                foreach (Frame frame in frames)
                {
                    for (; next < pictures.Length && pictures[next].TimeUs <= frame.TimeUs; next++)
                        history.Add(pictures[next].Color, pictures[next].TimeUs);
                    detector.Process(frame, detections);
                    trusted += detections.Prediction == PredictionState.Trusted ? 1 : 0;
                }
            }

            Assert.That(Allocation.Of(Round), Is.EqualTo(0));
            Assert.That(trusted, Is.GreaterThan(frames.Length));
        }

        [TestCase(nameof(PredictionSettings.MinCorrelation), double.NaN)]
        [TestCase(nameof(PredictionSettings.GainSlack), -0.1)]
        [TestCase(nameof(PredictionSettings.MaxUnexplainedShare), 1.5)]
        public void Constructor_BadSetting_NamesIt(string name, double value)
        {
            var settings = new PredictionSettings();
            typeof(PredictionSettings).GetProperty(name)!.SetValue(settings, value);
            var range = new MovingRange(MovingRange.Scenario(1, 1));
            ArgumentException? error = Assert.Throws<ArgumentException>(() => new ExpectedView(new RenderedFrameHistory(), range.Calibration, settings));
            Assert.That(error!.Message, Does.Contain(name));
        }

        private static Frame[] ReadAll(IFrameSource source)
        {
            var frames = new List<Frame>();
            using (source)
            {
                for (var frame = new Frame(); source.TryRead(frame); frame = new Frame())
                    frames.Add(frame);
            }

            return frames.ToArray();
        }

        private static IEnumerable<string> Frames(IEnumerable<Shot> shots) => shots.Select(s => s.FrameIndex + " " + s.Dot.PositionPx);
    }
}
