using System;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Session;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Health
{
    /// <summary>A camera that moves while it watches a known screen, and screens that show everything that moves without it.</summary>
    public sealed class DriftTests
    {
        private static readonly Vector2D[] Screen = { new Vector2D(70, 60), new Vector2D(250, 60), new Vector2D(250, 180), new Vector2D(70, 180) };

        [TestCase(2, 0, "right")]
        [TestCase(-2, 0, "left")]
        [TestCase(0, 3, "down", Category = "Long")]
        [TestCase(4, -4, "right and up")]
        [TestCase(-9, 0, "left", Category = "Long")]
        [TestCase(48, -30, "right and up")]
        public void PictureMonitor_BumpWhileThePictureSwitches_IsSaidOnceWithItsWay(int x, int y, string way)
        {
            MonitorRun run = Known(Screen);
            run.Play(0, 130, (b, i) => Draw(b, i, i < 45 ? 0 : x, i < 45 ? 0 : y));
            HealthEvent[] moved = Moved(run);
            Assert.That(moved, Has.Length.EqualTo(1), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(moved[0].Value, Is.EqualTo(new Vector2D(x, y).Length).Within(0.4));
            Assert.That(moved[0].Text, Does.Contain(" px " + way + " (").And.Contain("calibrate again"));
            Assert.That(moved[0].TimeUs, Is.LessThan((45 * run.IntervalUs) + 5_000_000), "within five seconds");
        }

        [TestCase(2, 0)]
        [TestCase(28, 20)]
        public void PictureMonitor_BumpAtTheVeryBeginning_IsSaid(int bump, int dark)
        {
            MonitorRun run = Known(Screen);
            run.Play(0, 100, (b, i) =>
            {
                Draw(b, i, i < bump ? 0 : 4, i < bump ? 0 : -3);
                if (i < dark)
                    b.Multiply(0.02f);
            });
            HealthEvent[] moved = Moved(run);
            Assert.That(moved, Has.Length.EqualTo(1), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(moved[0].Value, Is.EqualTo(5).Within(0.4));
        }

        [Test]
        public void PictureMonitor_PictureThatSwitchesAndPans_IsNoMovement()
        {
            MonitorRun run = Known(Screen);
            run.Play(0, 180, (b, i) => Draw(b, i, 0, 0));
            Assert.That(Moved(run), Is.Empty);
        }

        [Test]
        public void PictureMonitor_PersonBeforeAnEdge_IsNoMovement()
        {
            MonitorRun run = Known(Screen);
            run.Play(0, 150, (b, i) =>
            {
                Draw(b, i, 0, 0);
                if (i > 30)
                    b.Box(100 + i / 4 % 60, 80, 50, 160, 25, 35, 45);
            });
            Assert.That(Moved(run), Is.Empty);
        }

        [Test]
        public void PictureMonitor_SecondBump_IsSaidToo()
        {
            MonitorRun run = Known(Screen);
            run.Play(0, 200, (b, i) => Draw(b, i, i < 30 ? 0 : i < 120 ? 3 : 8, 0));
            Assert.That(Moved(run).Select(h => Math.Round(h.Value)), Is.EqualTo(new[] { 3, 8 }));
        }

        [Test]
        public void PictureMonitor_KnownScreen_WarmFramesAllocateNothing()
        {
            MonitorRun run = Known(Screen);
            run.Play(0, 30, (b, i) => Draw(b, i, 0, 0));
            int next = 30;
            Assert.That(Allocation.Of(() =>
            {
                run.Play(next, 24, (b, i) => Draw(b, i, i % 3, 0));
                next += 24;
            }), Is.EqualTo(0));
        }

        [TestCase(0, 0)]
        [TestCase(400, 300)]
        [TestCase(-3000, -2000)]
        public void PictureMonitor_ScreenLargerThanThePictureOrBesideIt_SaysNothingOfIt(int x, int y)
        {
            MonitorRun run = Known(new[] { new Vector2D(x - 50, y - 50), new Vector2D(x + 370, y - 50), new Vector2D(x + 370, y + 290), new Vector2D(x - 50, y + 290) });
            run.Play(0, 45, (b, i) => MonitorRun.Room(b));
            Assert.That(Moved(run), Is.Empty);
        }

        [TestCase(ProjectedContent.Bay, 0.94)]
        [TestCase(ProjectedContent.Shapes, 0.94)]
        [TestCase(ProjectedContent.ShapesOverTexture, 0.94)]
        [TestCase(ProjectedContent.ShapesOverTexture, 0.02)]
        [Category("Long")]
        public void PictureMonitor_SimulatedContentMoves_OnlyTheCameraCounts(ProjectedContent content, double speed)
        {
            SimulationScenario scenario = Room(content, speed);
            scenario.Nudges.Add(new NudgeSettings { TimeS = 3, ShiftPx = new Vector2D(-1.6, 1.2) });
            HealthEvent[] moved = Moved(Play(scenario));
            Assert.That(moved, Has.Length.EqualTo(1));
            Assert.That(moved[0].TimeUs, Is.GreaterThan(3_000_000), "at rest");
            Assert.That(moved[0].Value, Is.EqualTo(2).Within(0.5));
            Assert.That(moved[0].Text, Does.Contain("left and down"));
        }

        [Test]
        [Category("Long")]
        public void PictureMonitor_SlowDrift_IsSaidOnceInTime()
        {
            SimulationScenario scenario = Room(ProjectedContent.Shapes, 0.5);
            scenario.DurationS = 8;
            for (int i = 0; i < 12; i++)
                scenario.Nudges.Add(new NudgeSettings { TimeS = 1 + 0.4 * i, ShiftPx = new Vector2D(0.2, 0) });
            HealthEvent[] moved = Moved(Play(scenario));
            Assert.That(moved, Has.Length.EqualTo(1));
            Assert.That(moved[0].Text, Does.Contain("px right ("));

            // Two pixels are reached after ten of the steps.
            Assert.That(moved[0].TimeUs, Is.LessThan(5_000_000 + 5_000_000));
        }

        private static MonitorRun Known(Vector2D[] screen)
        {
            var run = new MonitorRun(framesPerSecond: 15, format: PixelFormat.Gray8);
            run.Monitor.SetScreenPolygon(screen);
            return run;
        }

        private static HealthEvent[] Moved(MonitorRun run) => run.Said.Where(h => h.Kind == HealthKind.CameraMoved).ToArray();

        /// <summary>A wall with a screen on it that switches between four pictures, one of which pans; camera displaced by x, y.</summary>
        private static void Draw(FrameBuilder builder, int frame, int x, int y)
        {
            builder.Wall(40, 50, 45);
            int scene = frame / 22 % 4;
            float level = scene == 0 ? 150 : scene == 1 ? 90 : scene == 2 ? 220 : 120;
            builder.Box(70 + x, 60 + y, 180, 120, level, level, level);
            for (int i = 0; i < 6 && scene != 2; i++)
            {
                int left = 80 + i * 29 + (scene == 1 ? frame / 3 % 20 : 0);
                builder.Box(left + x, 70 + i % 3 * 35 + y, 18, 25, 255 - level, 200 - level / 2, 250 - level);
            }
        }

        private static MonitorRun Play(SimulationScenario scenario)
        {
            var range = new SimulatedRange(scenario, SimulationScenes.Empty());
            MonitorRun run = Known(range.Calibration.Screen.OutlinePx);
            using IFrameSource source = range.CreateColorSource();
            return run.Play(source);
        }

        private static SimulationScenario Room(ProjectedContent content, double speed)
        {
            var scenario = new SimulationScenario { Seed = 7, DurationS = 6 };
            scenario.ColorCamera.Width = 480;
            scenario.ColorCamera.Height = 270;
            scenario.ColorCamera.FramesPerSecond = 15;
            scenario.DepthCamera.Enabled = false;
            scenario.Projector.Width = 320;
            scenario.Projector.Height = 180;
            scenario.Projector.RefreshHz = 30;
            scenario.Projector.Content = content;
            scenario.Projector.ContentSpeed = speed;
            return scenario;
        }
    }
}
