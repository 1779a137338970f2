using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed class SimulatedColorSourceTests
    {
        private const int Green = 1;

        [Test]
        public void SimulatedColorSource_UnsaturatedDot_LiesWhereTruthSays()
        {
            for (int i = 0; i < 6; i++)
            {
                SimulationScenario scenario = SimulationExamples.Linear();
                scenario.Shooters[0].Laser.PowerMw = 0.6;
                scenario.Shots.Add(new ShotSettings { TimeS = 0.05, PulseMs = 200, ScreenM = new Vector2D(0.5 + 0.43 * i, 1.5 - 0.21 * i) });
                SimulatedRange range = Build(scenario, out byte[] with, out byte[] without, 3);
                TrueDot dot = range.Truth.DotsOf(3)[0];
                Light(with, without, dot.PositionPx, 7, out Vector2D centroid, out int peak);
                Assert.That(peak, Is.InRange(60, 254), "unsaturated");
                Assert.That((centroid - dot.PositionPx).Length, Is.LessThan(0.1), "shot " + i);
                Vector2D calibrated = range.Calibration.Screen.ToScreenM(dot.PositionPx);
                Assert.That((calibrated - range.Truth.Shots[0].ScreenM).Length, Is.LessThan(1e-9));
            }
        }

        [Test]
        public void SimulatedColorSource_StreakingDot_LiesWhereTruthSays()
        {
            SimulationScenario scenario = SimulationExamples.Linear();
            scenario.Shooters[0].Laser.PowerMw = 1.5;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.09, PulseMs = 40, ScreenM = new Vector2D(1.4, 0.8), SweepMPerS = new Vector2D(8, 3) });
            SimulatedRange range = Build(scenario, out byte[] with, out byte[] without, 3);
            TrueDot dot = range.Truth.DotsOf(3)[0];
            Light(with, without, dot.PositionPx, 18, out Vector2D centroid, out int peak);
            Assert.That(peak, Is.InRange(30, 254));
            Assert.That(dot.StreakPx.Length, Is.GreaterThan(8));
            Assert.That((centroid - dot.PositionPx).Length, Is.LessThan(0.1));
            Assert.That(((dot.FirstPx + dot.LastPx) * 0.5 - dot.PositionPx).Length, Is.LessThan(0.2));
        }

        [Test]
        public void SimulatedColorSource_DotOfTruePeak_RisesByIt()
        {
            SimulationScenario scenario = SimulationExamples.Linear();
            scenario.Shooters[0].Laser.PowerMw = 0.6;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.05, PulseMs = 200, ScreenM = new Vector2D(1.6, 0.9) });
            SimulatedRange range = Build(scenario, out byte[] with, out byte[] without, 3);
            TrueDot dot = range.Truth.DotsOf(3)[0];
            Light(with, without, dot.PositionPx, 7, out _, out int peak);
            Assert.That(peak / 255.0 / dot.Peak, Is.InRange(0.8, 1.02));
        }

        [TestCase(LaserColor.Green)]
        [TestCase(LaserColor.Red)]
        public void SimulatedColorSource_StrongDot_HasWhiteCoreAndColouredRim(LaserColor color)
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.Shooters[0].Laser.Color = color;
            scenario.Shooters[0].Laser.PowerMw = color == LaserColor.Red ? 140 : 60;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.05, PulseMs = 200, ScreenM = new Vector2D(1.6, 0.9) });
            SimulatedRange range = Build(scenario, out byte[] with, out _, 3);
            Vector2D center = range.Truth.DotsOf(3)[0].PositionPx;
            int core = 0, rim = 0;
            for (int y = (int)center.Y - 10; y <= center.Y + 10; y++)
            for (int x = (int)center.X - 10; x <= center.X + 10; x++)
            {
                int o = (y * 320 + x) * 4, own = color == LaserColor.Red ? 2 : 1, other = 3 - own;
                if (with[o] >= 240 && with[o + 1] >= 240 && with[o + 2] >= 240)
                    core++;
                else if (with[o + own] > 120 && with[o + own] - with[o + other] > 40 && with[o + own] - with[o] > 40)
                    rim++;
            }

            int middle = ((int)Math.Round(center.Y) * 320 + (int)Math.Round(center.X)) * 4;
            Assert.That(Math.Min(with[middle], Math.Min(with[middle + 1], with[middle + 2])), Is.GreaterThanOrEqualTo(240));
            Assert.That(core, Is.InRange(2, 60));
            Assert.That(rim, Is.GreaterThan(core / 2));
        }

        [Test]
        public void SimulatedColorSource_PulseAcrossTwoExposures_ShowsItsSharesInBoth()
        {
            SimulationScenario scenario = SimulationExamples.Linear();
            scenario.ColorCamera.ExposureUs = 33333;
            scenario.ColorCamera.StartUs = 0;
            scenario.Shooters[0].Laser.PowerMw = 3;
            // The exposures of frames 2 and 3 meet at 2.5 frame periods: 2 ms of the pulse lie before, 3 ms after.
            double border = 2.5 / 30;
            scenario.Shots.Add(new ShotSettings { TimeS = border - 0.002, PulseMs = 5, ScreenM = new Vector2D(1.6, 0.9) });
            SimulatedRange range = Build(scenario, out byte[] with2, out byte[] without2, 2);
            byte[] with3 = SimulationExamples.ColorFrame(range, 3), without3 = SimulationExamples.ColorFrame(Dark(scenario), 3);
            TrueShot shot = range.Truth.Shots[0];
            Assert.That(shot.FirstFrame, Is.EqualTo(2));
            Assert.That(shot.LastFrame, Is.EqualTo(3));
            double first = Light(with2, without2, range.Truth.DotsOf(2)[0].PositionPx, 7, out _, out int peak2);
            double second = Light(with3, without3, range.Truth.DotsOf(3)[0].PositionPx, 7, out _, out int peak3);
            Assert.That(Math.Max(peak2, peak3), Is.LessThan(255));
            Assert.That(first / (first + second), Is.EqualTo(0.4).Within(0.02));
            Assert.That(range.Truth.DotsOf(2)[0].LightUs, Is.EqualTo(2000).Within(2));
        }

        [Test]
        public void SimulatedColorSource_PulseBetweenExposures_IsSeenByNoFrame()
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.ColorCamera.ExposureUs = 2500;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.128, PulseMs = 5, ScreenM = new Vector2D(1.6, 0.9) });
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            Assert.That(range.Truth.Shots[0].FirstFrame, Is.EqualTo(-1));
        }

        [Test]
        public void SimulatedColorSource_RollingShutter_ExposesLowerRowsLater()
        {
            SimulationScenario scenario = SimulationExamples.Linear();
            scenario.ColorCamera.RollingShutterRowUs = 50;
            scenario.ColorCamera.ExposureUs = 10000;
            scenario.Shooters.Add(SimulationExamples.Steady());
            // The middle row of frame 3 is exposed from 111.667 to 121.667 ms; this pulse ends at 114.667.
            double start = (16667 + 3e6 / 30 - 5000) / 1e6 - 0.005;
            scenario.Shots.Add(new ShotSettings { TimeS = start, PulseMs = 8, ScreenM = new Vector2D(1.6, 0.3) });
            scenario.Shots.Add(new ShotSettings { TimeS = start, PulseMs = 8, Shooter = 2, ScreenM = new Vector2D(1.6, 1.5) });
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            ReadOnlySpan<TrueDot> dots = range.Truth.DotsOf(3);
            Assert.That(dots.Length, Is.EqualTo(2));
            double rows = dots[1].PositionPx.Y - dots[0].PositionPx.Y;
            Assert.That(rows, Is.GreaterThan(60));
            Assert.That(dots[0].LightUs - dots[1].LightUs, Is.EqualTo(50 * rows).Within(1));
            Assert.That(dots[0].LightUs, Is.EqualTo(3000 + 50 * (89.5 - dots[0].PositionPx.Y)).Within(1));
        }

        [Test]
        public void SimulatedColorSource_Nudge_DisplacesPictureAndTruth()
        {
            SimulationScenario scenario = SimulationExamples.Linear();
            scenario.Shooters[0].Laser.PowerMw = 0.6;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.05, PulseMs = 300, ScreenM = new Vector2D(1.6, 0.9) });
            scenario.Nudges.Add(new NudgeSettings { TimeS = 0.2, ShiftPx = new Vector2D(3.25, -2.5) });
            SimulatedRange range = Build(scenario, out byte[] with, out byte[] without, 8);
            TrueDot before = range.Truth.DotsOf(3)[0], after = range.Truth.DotsOf(8)[0];
            Assert.That((after.PositionPx - before.PositionPx - new Vector2D(3.25, -2.5)).Length, Is.LessThan(1e-9));
            Light(with, without, after.PositionPx, 7, out Vector2D centroid, out _);
            Assert.That((centroid - after.PositionPx).Length, Is.LessThan(0.1));
            byte[] still = SimulationExamples.ColorFrame(Dark(scenario), 3);
            double moved = 0;
            for (int i = 0; i < still.Length; i++)
                moved = Math.Max(moved, Math.Abs(still[i] - without[i]));
            Assert.That(moved, Is.GreaterThan(5), "the picture itself moved");
        }

        [Test]
        public void SimulatedColorSource_MovingTargets_LookTheSameWhereverTheStreamBegan()
        {
            SimulationScenario early = SimulationExamples.Linear(0.6), late = SimulationExamples.Linear(0.6);
            early.ColorCamera.StartUs = 16667;
            late.ColorCamera.StartUs = 16667 + 15 * 1e6 / 30;
            byte[] a = SimulationExamples.ColorFrame(new SimulatedRange(early, SimulationScenes.Default()), 15);
            byte[] b = SimulationExamples.ColorFrame(new SimulatedRange(late, SimulationScenes.Default()), 0);
            byte[] first = SimulationExamples.ColorFrame(new SimulatedRange(early, SimulationScenes.Default()), 0);
            Assert.That(a, Is.EqualTo(b));
            Assert.That(a, Is.Not.EqualTo(first));
        }

        [Test]
        public void SimulatedColorSource_Flicker_ChangesBrightnessFromFrameToFrame()
        {
            SimulationScenario scenario = SimulationExamples.Linear();
            scenario.Room.Ambient = 0.5;
            scenario.Room.FlickerDepth = 0.5;
            scenario.ColorCamera.ExposureUs = 2500;
            scenario.ColorCamera.Gain = 6;
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            double low = 1e9, high = 0;
            for (int i = 0; i < 5; i++)
            {
                double sum = 0;
                foreach (byte value in SimulationExamples.ColorFrame(range, i))
                    sum += value;
                low = Math.Min(low, sum);
                high = Math.Max(high, sum);
            }

            Assert.That(high / low, Is.GreaterThan(1.05));
        }

        [Test]
        public void SimulatedColorSource_PackedFormats_AreTheSamePictureInBt601()
        {
            SimulationScenario scenario = SimulationExamples.Small();
            byte[] bgra = SimulationExamples.ColorFrame(new SimulatedRange(scenario, SimulationScenes.Default()), 0);
            scenario.ColorCamera.Format = PixelFormat.Nv12;
            byte[] nv12 = SimulationExamples.ColorFrame(new SimulatedRange(scenario, SimulationScenes.Default()), 0);
            scenario.ColorCamera.Format = PixelFormat.Yuy2;
            byte[] yuy2 = SimulationExamples.ColorFrame(new SimulatedRange(scenario, SimulationScenes.Default()), 0);
            for (int y = 0; y < 180; y++)
            for (int x = 0; x < 320; x++)
            {
                int o = (y * 320 + x) * 4;
                double luma = 0.299 * bgra[o + 2] + 0.587 * bgra[o + 1] + 0.114 * bgra[o];
                Assert.That(nv12[y * 320 + x], Is.EqualTo(luma).Within(0.51));
                Assert.That(yuy2[(y * 320 + x) * 2], Is.EqualTo(luma).Within(0.51));
                if (x % 2 != 0)
                    continue;
                double u = 128 + 0.564 * ((bgra[o] + bgra[o + 4]) / 2.0 - (luma + Luma(bgra, o + 4)) / 2);
                Assert.That(yuy2[(y * 320 + x) * 2 + 1], Is.EqualTo(u).Within(0.6));
                if (y % 2 != 0)
                    continue;
                int below = o + 320 * 4;
                double red = (bgra[o + 2] + bgra[o + 6] + bgra[below + 2] + bgra[below + 6]) / 4.0;
                double mean = (luma + Luma(bgra, o + 4) + Luma(bgra, below) + Luma(bgra, below + 4)) / 4;
                Assert.That(nv12[320 * 180 + y / 2 * 320 + x + 1], Is.EqualTo(128 + 0.713 * (red - mean)).Within(0.6));
            }
        }

        [Test]
        public void SimulatedColorSource_Jpeg_LosesALittle()
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.ColorCamera.Format = PixelFormat.Nv12;
            byte[] raw = SimulationExamples.ColorFrame(new SimulatedRange(scenario, SimulationScenes.Default()), 0);
            scenario.ColorCamera.JpegQuality = 75;
            byte[] compressed = SimulationExamples.ColorFrame(new SimulatedRange(scenario, SimulationScenes.Default()), 0);
            Assert.That(compressed.Length, Is.EqualTo(raw.Length));
            double squares = 0;
            for (int i = 0; i < 320 * 180; i++)
                squares += (raw[i] - compressed[i]) * (raw[i] - compressed[i]);
            Assert.That(Math.Sqrt(squares / (320 * 180)), Is.InRange(0.3, 5));
        }

        [Test]
        public void SimulatedColorSource_ShotNoise_HasTheSensorsStandardDeviation()
        {
            SimulationScenario scenario = SimulationExamples.Linear(1.3);
            scenario.ColorCamera.FullWellElectrons = 2000;
            scenario.ColorCamera.ReadNoiseElectrons = 10;
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            using IFrameSource source = range.CreateColorSource();
            using var frame = new Frame();
            const int offset = (100 * 320 + 100) * 4, samples = 200;
            var sum = new double[samples];
            var squares = new double[samples];
            int n = 0;
            for (; source.TryRead(frame); n++)
            {
                for (int i = 0; i < samples; i++)
                {
                    double value = frame.Color.Bytes[offset + i * 4 + Green] / 255.0;
                    sum[i] += value;
                    squares[i] += value * value;
                }
            }

            double variance = 0, expected = 0;
            for (int i = 0; i < samples; i++)
            {
                double mean = sum[i] / n;
                variance += (squares[i] - n * mean * mean) / (n - 1) / samples;
                expected += (mean / 2000 + 100.0 / (2000.0 * 2000) + 1 / 12.0 / 255 / 255) / samples;
            }

            Assert.That(Math.Sqrt(variance / expected), Is.EqualTo(1).Within(0.06));
        }

        [Test]
        [Category("Long")]
        public void SimulatedColorSource_DarkPersonBeforeMovingPicture_NothingOnThemIsBrighterThanThePictureIs()
        {
            SimulationScenario scenario = SimulationExamples.Linear(0.2);
            scenario.Projector.Content = ProjectedContent.Shapes;
            scenario.ColorCamera.BlurPx = 0;
            scenario.Room.FlickerDepth = 0.5;
            scenario.Room.Ambient = 0.01;
            scenario.Projector.Width = 840;
            scenario.Projector.Height = 472;
            var clear = new SimulatedRange(SimulationScenarioFile.Parse(SimulationScenarioFile.ToJson(scenario), "copy"), SimulationExamples.EmptyScene());
            scenario.Room.Obstacles.Add(new ObstacleSettings { TopM = new Vector2D(1.6, 1.2), Reflectance = 0.05 });
            var hidden = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            using IFrameSource clearSource = clear.CreateColorSource(), hiddenSource = hidden.CreateColorSource();
            using Frame clearFrame = new Frame(), hiddenFrame = new Frame();
            int darker = 0;
            while (clearSource.TryRead(clearFrame) && hiddenSource.TryRead(hiddenFrame))
            {
                int brightest = 0;
                foreach (byte value in clearFrame.Color.Bytes)
                    brightest = Math.Max(brightest, value == 255 ? 0 : value);
                for (int i = 0; i < 320 * 180 * 4; i++)
                {
                    darker += hiddenFrame.Color.Bytes[i] < clearFrame.Color.Bytes[i] - 5 ? 1 : 0;
                    if (i % 4 != 3 && hiddenFrame.Color.Bytes[i] > brightest + 2)
                        Assert.Fail($"frame {hiddenFrame.Index}: {hiddenFrame.Color.Bytes[i]} over {brightest} at {i / 4 % 320},{i / 1280}");
                }
            }

            Assert.That(darker, Is.GreaterThan(1000), "there is somebody");
        }

        private static double Luma(byte[] bgra, int o) => 0.299 * bgra[o + 2] + 0.587 * bgra[o + 1] + 0.114 * bgra[o];

        // The same frame with and without lasers.
        private static SimulatedRange Build(SimulationScenario scenario, out byte[] with, out byte[] without, int frame)
        {
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            with = SimulationExamples.ColorFrame(range, frame);
            without = SimulationExamples.ColorFrame(Dark(scenario), frame);
            return range;
        }

        private static SimulatedRange Dark(SimulationScenario scenario)
        {
            SimulationScenario dark = SimulationScenarioFile.Parse(SimulationScenarioFile.ToJson(scenario), "copy");
            foreach (ShooterSettings shooter in dark.Shooters)
                shooter.Laser.PowerMw = 0;
            return new SimulatedRange(dark, SimulationExamples.EmptyScene());
        }

        private static double Light(byte[] with, byte[] without, Vector2D around, int reach, out Vector2D centroid, out int peak)
        {
            peak = 0;
            for (int y = (int)around.Y - 3; y <= around.Y + 3; y++)
            for (int x = (int)around.X - 3; x <= around.X + 3; x++)
                peak = Math.Max(peak, with[(y * 320 + x) * 4 + Green]);
            double sum = SimulationExamples.Light(with, without, 320, 180, Green, around, reach, out centroid);
            return sum;
        }
    }
}
