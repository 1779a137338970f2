using System;
using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Health
{
    /// <summary>Without a calibrated screen: a picture that moves is not the camera; one that takes the room along is.</summary>
    public sealed class PanningTests
    {
        private const int Fps = 15;

        [TestCase(0.15, 0)]
        [TestCase(0.4, 0.3, Category = "Long")]
        [TestCase(1, 0, Category = "Long")]
        [TestCase(0, -2)]
        [TestCase(-3, 3)]
        [TestCase(8, 0, Category = "Long")]
        [TestCase(25, -10)]
        [Category("Long")]
        public void PictureMonitor_PictureThatFillsTheViewPans_IsNoMovedCamera(double x, double y)
        {
            MonitorRun run = Play(10, t => new Vector2D(x, y) * t);
            AssertUnclear(run);
        }

        [TestCase(0.5, 0, 2.0)]
        [TestCase(2, 1, 1.5, Category = "Long")]
        [TestCase(-4, 4, 2.5, Category = "Long")]
        [TestCase(6, 0, 1.2)]
        [TestCase(0, 15, 4.0)]
        [Category("Long")]
        public void PictureMonitor_PanThatStartsAndStops_IsNoMovedCamera(double x, double y, double seconds)
        {
            // Rests for three seconds, pans, rests for four, pans back, rests.
            MonitorRun run = Play((int)Math.Ceiling(10 + 2 * seconds), t => new Vector2D(x, y) * (Math.Min(Math.Max(t - 3, 0), seconds) - Math.Min(Math.Max(t - 7 - seconds, 0), seconds)));
            AssertUnclear(run);
        }

        [TestCase(0.5)]
        [TestCase(3)]
        public void PictureMonitor_PanThatEasesInAndOut_IsNoMovedCamera(double amplitude)
        {
            MonitorRun run = Play(16, t => new Vector2D(amplitude * (1 - Math.Cos(t * 2 * Math.PI / 6)), amplitude * Math.Sin(t * 2 * Math.PI / 8)));
            AssertUnclear(run);
        }

        [TestCase(2.0, 0.0)]
        [TestCase(-6.0, 7.0)]
        [TestCase(0.0, 15.0)]
        public void PictureMonitor_PictureThatFillsTheViewJumps_IsUnclearOnceAndNoMovedCamera(double x, double y)
        {
            // From rest to rest, there, on and back: the first jump cannot be told from a camera's by anybody.
            MonitorRun run = Play(13, t => new Vector2D(x, y) * (t < 3 ? 0 : t < 6.5 ? 1 : t < 10 ? 2.2 : 0));
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.MotionUnclear }), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(run.Said[0].Value, Is.EqualTo(new Vector2D(x, y).Length).Within(0.5));
            Assert.That(run.Said[0].Text, Does.Contain("calibrate").And.Contain("the room around the picture"));
        }

        [TestCase(2.0, 0.0, 15)]
        [TestCase(-1.5, 1.5, 15)]
        [TestCase(0.0, 7.0, 15)]
        [TestCase(-12.0, 4.0, 30)]
        [TestCase(24.0, -21.0, 15)]
        [Category("Long")]
        public void PictureMonitor_CameraThatSteps_IsSaidWithinFiveSeconds(double x, double y, int framesPerSecond)
        {
            // Over in a fifth of a second, with an overshoot.
            MonitorRun run = PlayInRoom(7, _ => default, t => new Vector2D(x, y) * (t < 3.03 ? 0 : t < 3.1 ? 0.6 : t < 3.2 ? 1.2 : 1), framesPerSecond);
            AssertMoved(run, x, y);
            Assert.That(run.Said[0].TimeUs, Is.LessThan(3_030_000 + 5_000_000));
        }

        [TestCase(0.1, 0.0)]
        [TestCase(0.3, 0.0)]
        [TestCase(1.1, 0.0)]
        [TestCase(2.0, 1.0)]
        public void PictureMonitor_CameraThatStepsAtTheVeryBeginning_IsSaid(double seconds, double dark)
        {
            // While the first look is taken, or soon after the camera found its exposure; the picture scrolls all the time.
            var run = new MonitorRun(framesPerSecond: Fps, format: PixelFormat.Gray8);
            run.Play(0, 8 * Fps, (b, i) =>
            {
                double t = i / (double)Fps;
                var moved = new Vector2D(t < seconds ? 0 : 4, t < seconds ? 0 : -3);
                Content(b, new Vector2D(5 * t, 0) + moved);
                Room(b, moved);
                if (t < dark)
                    b.Multiply(0.02f);
            });
            HealthEvent[] said = run.Said.Where(h => h.Kind == HealthKind.CameraMoved || h.Kind == HealthKind.MotionUnclear).ToArray();
            Assert.That(said.Select(h => h.Kind), Is.EqualTo(new[] { HealthKind.CameraMoved }), string.Join("; ", said.Select(h => h.Text)));
            Assert.That(said[0].Value, Is.EqualTo(5).Within(0.5));
            Assert.That(said[0].TimeUs, Is.LessThan(1e6 * (seconds + 5)));
        }

        [Test]
        public void PictureMonitor_CameraThatStepsRightAfterThePicturePanned_IsSaid()
        {
            MonitorRun run = PlayInRoom(11, t => new Vector2D(6 * Math.Min(Math.Max(t - 2, 0), 4), 0), t => new Vector2D(t < 7 ? 0 : 3, 0), Fps);
            AssertMoved(run, 3, 0);
        }

        [TestCase(2.0, 0.0)]
        [TestCase(-6.0, 7.0)]
        public void PictureMonitor_PictureJumpsInsideOfARoom_SaysNothing(double x, double y)
        {
            MonitorRun run = PlayInRoom(13, t => new Vector2D(x, y) * (t < 3 ? 0 : t < 6.5 ? 1 : t < 10 ? 2.2 : 0), _ => default, Fps);
            Assert.That(run.Said.Select(h => h.Text), Is.Empty);
        }

        [TestCase(0.5, 0.2, 5)]
        [TestCase(-3, 1, 4, Category = "Long")]
        [TestCase(10, -4, 3)]
        [TestCase(-26, 7, 1)]
        public void PictureMonitor_CameraThatCreepsAndRests_IsSaid(double x, double y, double seconds)
        {
            MonitorRun run = PlayInRoom((int)seconds + 8, _ => default, t => new Vector2D(x, y) * Math.Min(Math.Max(t - 3, 0), seconds), Fps);
            Assert.That(run.Kinds, Is.Not.Empty.And.All.EqualTo(HealthKind.CameraMoved), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(run.Said.Sum(h => h.Value), Is.EqualTo(new Vector2D(x, y).Length * seconds).Within(0.7 + (0.05 * new Vector2D(x, y).Length * seconds)));
        }

        private static void AssertMoved(MonitorRun run, double x, double y)
        {
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.CameraMoved }), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(run.Said[0].Value, Is.EqualTo(new Vector2D(x, y).Length).Within(0.5));
        }

        [Test]
        public void PictureMonitor_PanInsideOfAStillRoom_SaysNothing()
        {
            var run = new MonitorRun(framesPerSecond: Fps, format: PixelFormat.Gray8);
            run.Play(0, 9 * Fps, (b, i) =>
            {
                Content(b, new Vector2D(1.5 * i / Fps, 0));

                // A still frame of things around the panning picture: two of twelve blocks see it.
                b.Box(0, 0, 320, 26, 30, 40, 35);
                for (int k = 0; k < 12; k++)
                    b.Box(6 + k * 26, 3, 9 + k % 3 * 5, 20, 150, 120, 90);
                b.Box(0, 0, 30, 240, 30, 40, 35);
                for (int k = 0; k < 10; k++)
                    b.Box(4, 4 + k * 23, 22, 8 + k % 3 * 4, 60, 150, 120);
                b.Box(290, 0, 30, 240, 30, 40, 35);
                for (int k = 0; k < 10; k++)
                    b.Box(295, 4 + k * 23, 22, 8 + k % 3 * 4, 140, 60, 120);
            });
            Assert.That(run.Said.Select(h => h.Kind), Has.None.EqualTo(HealthKind.CameraMoved));
        }

        [Test]
        public void PictureMonitor_PanningPicture_WarmFramesAllocateNothing()
        {
            var run = new MonitorRun(framesPerSecond: Fps, format: PixelFormat.Gray8);
            using var frame = new Capture.Frame();
            int next = 0;
            void Show(int count)
            {
                for (int i = 0; i < count; i++, next++)
                {
                    Content(run.Builder, new Vector2D(next * 0.1, 0));
                    run.Builder.Write(frame, next, next * run.IntervalUs, PixelFormat.Gray8);
                    long before = GC.GetAllocatedBytesForCurrentThread();
                    run.Monitor.Process(frame);
                    if (next >= 120)
                        Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
                }
            }

            Show(170);
        }

        private static void AssertUnclear(MonitorRun run)
        {
            Assert.That(run.Said.Select(h => h.Kind), Has.None.EqualTo(HealthKind.CameraMoved), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(run.Said.Count(h => h.Kind == HealthKind.MotionUnclear), Is.LessThanOrEqualTo(1));
        }

        private static MonitorRun Play(int seconds, Func<double, Vector2D> offset, int framesPerSecond = Fps)
        {
            var run = new MonitorRun(framesPerSecond: framesPerSecond, format: PixelFormat.Gray8);
            run.Play(0, seconds * framesPerSecond, (b, i) => Content(b, offset(i / (double)framesPerSecond)));
            return run;
        }

        private static MonitorRun PlayInRoom(int seconds, Func<double, Vector2D> offset, Func<double, Vector2D> camera, int framesPerSecond)
        {
            var run = new MonitorRun(framesPerSecond: framesPerSecond, format: PixelFormat.Gray8);
            return run.Play(0, seconds * framesPerSecond, (b, i) =>
            {
                double t = i / (double)framesPerSecond;
                Vector2D moved = camera(t);
                Content(b, offset(t) + moved);
                Room(b, moved);
            });
        }

        /// <summary>Light on the picture's place, a dark wall round it; edges with fractions of a pixel.</summary>
        private static void Room(FrameBuilder builder, Vector2D moved)
        {
            float[] across = Cover(320, 42.3 + moved.X, 277.6 + moved.X), down = Cover(240, 38.7 + moved.Y, 203.2 + moved.Y);
            for (int y = 0; y < 240; y++)
            for (int x = 0; x < 320; x++)
            {
                float inside = Math.Min(across[x], down[y]);
                builder.Gray(x, y, 22 * (1 - inside) + (45 + 0.75f * builder.Gray(x, y)) * inside);
            }
        }

        /// <summary>How much of each pixel lies between two places.</summary>
        private static float[] Cover(int count, double from, double to)
        {
            var cover = new float[count];
            for (int i = 0; i < count; i++)
                cover[i] = (float)Math.Max(0, Math.Min(1, Math.Min(i - from, to - i) + 0.5));
            return cover;
        }

        /// <summary>A picture without end that fills the view, sampled with fractions of a pixel: sums of waves of no common period.</summary>
        private static void Content(FrameBuilder builder, Vector2D offset)
        {
            // Each wave is that of a sum of angles, so that sines are taken by row and by column only.
            float[][] ofX = Angles(320, offset.X, 0.137, 0.071, 0.283), ofY = Angles(240, offset.Y, 0.191, 0.043, -0.117);
            float[] x0 = ofX[0], x1 = ofX[1], x2 = ofX[2], x4 = ofX[4], x5 = ofX[5];
            for (int y = 0; y < 240; y++)
            {
                float level = 110 + 25 * ofY[0][y], y1 = 22 * ofY[1][y], y2 = 18 * ofY[2][y], y4 = 22 * ofY[4][y], y5 = 18 * ofY[5][y];
                for (int x = 0; x < 320; x++)
                    builder.Gray(x, y, level + 30 * x0[x] + x1[x] * y4 + x4[x] * y1 + x2[x] * y5 + x5[x] * y2);
            }
        }

        /// <summary>Sines, then cosines, of three waves.</summary>
        private static float[][] Angles(int count, double offset, params double[] waves)
        {
            var angles = new float[6][];
            for (int wave = 0; wave < 3; wave++)
            {
                angles[wave] = new float[count];
                angles[3 + wave] = new float[count];
                for (int i = 0; i < count; i++)
                {
                    angles[wave][i] = (float)Math.Sin((i - offset) * waves[wave]);
                    angles[3 + wave][i] = (float)Math.Cos((i - offset) * waves[wave]);
                }
            }

            return angles;
        }
    }
}
