using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Health
{
    public sealed class PictureMonitorTests
    {
        [Test]
        public void PictureMonitor_OrdinaryNoisyRoom_SaysNothing()
        {
            var run = new MonitorRun();
            run.Builder.NoiseSigma = 4;
            run.Play(0, 240, (b, i) => MonitorRun.Room(b));
            Assert.That(run.Said.Select(h => h.Text), Is.Empty);
        }

        [Test]
        public void PictureMonitor_ThingsThatMoveAndLasers_SaysNothing()
        {
            var run = new MonitorRun();
            run.Play(0, 240, (b, i) =>
            {
                MonitorRun.Room(b);
                b.Box(20 + i % 200, 60, 60, 120, 150, 90, 40).Box(250 - i * 3 % 200, 20, 50, 80, 20, 180, 160);
                if (i % 20 < 3)
                    b.GreenDot(160, 120);
            });
            Assert.That(run.Said.Select(h => h.Text), Is.Empty);
        }

        [Test]
        public void PictureMonitor_PartOfTheScreenSaturated_SaysHowMuchToLowerTheExposureOnce()
        {
            var run = new MonitorRun(new PictureMonitorSettings { ExposureUs = 10_000 });
            run.Play(0, 60, (b, i) => b.Wall(80, 80, 80).Box(0, 0, 320, 60, 400, 400, 400));
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.Overexposed }));
            Assert.That(run.Said[0].Value, Is.EqualTo(0.25).Within(0.01));
            Assert.That(run.Said[0].Text, Does.Contain("25 % of the screen").And.Contain("lower the exposure to 2.7 ms or less"));
            run.Play(60, 60, (b, i) => b.Wall(80, 80, 80));
            Assert.That(run.Said.Count(h => h.Kind == HealthKind.Overexposed), Is.EqualTo(2), "and that it is over");
        }

        [Test]
        public void PictureMonitor_SaturatedBesideTheScreen_IsNoMatter()
        {
            var run = new MonitorRun();
            run.Monitor.SetScreenPolygon(new[] { new Vector2D(0, 80), new Vector2D(320, 80), new Vector2D(320, 240), new Vector2D(0, 240) });
            run.Play(0, 60, (b, i) => b.Wall(80, 80, 80).Box(0, 0, 320, 60, 400, 400, 400));
            Assert.That(run.Kinds, Is.Empty);
        }

        [Test]
        public void PictureMonitor_ShareAboutTheLimit_IsSaidOnce()
        {
            var run = new MonitorRun();
            run.Play(0, 300, (b, i) => b.Wall(80, 80, 80).Box(0, 0, 320, i % 30 < 15 ? 14 : 11, 400, 400, 400));
            Assert.That(run.Kinds.Length, Is.LessThanOrEqualTo(1));
        }

        [Test]
        public void PictureMonitor_AlmostBlack_SaysSo()
        {
            var run = new MonitorRun();
            run.Play(0, 120, (b, i) => b.Wall(6, 6, 6).Box(100, 100, 60, 60, 14, 14, 14));
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.Underexposed }));
            Assert.That(run.Said[0].Text, Does.Contain("raise the exposure"));
        }

        [Test]
        public void PictureMonitor_SamePictureForASecond_IsFrozenUntilItMoves()
        {
            var run = new MonitorRun();
            run.Play(0, 20, (b, i) => MonitorRun.Room(b)).Repeat(20, 45).Play(65, 20, (b, i) => MonitorRun.Room(b));
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.PictureFrozen, HealthKind.PictureFrozen }));
            Assert.That(run.Said[0].FrameIndex, Is.InRange(45, 55));
            Assert.That(run.Said[1].Text, Does.Contain("moves again after 1.5 s"));
        }

        [TestCase(1.12f, "more light")]
        [TestCase(0.85f, "less light")]
        public void PictureMonitor_WholePictureBrighterAtOnce_IsAnExposureChange(float factor, string words)
        {
            var run = new MonitorRun();
            run.Play(0, 200, (b, i) => MonitorRun.Room(b, light: i < 100 ? 1 : factor));
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.ExposureChange }));
            Assert.That(run.Said[0].FrameIndex, Is.InRange(100, 111));
            Assert.That(run.Said[0].Value, Is.EqualTo(System.Math.Pow(factor, 2.2)).Within(0.05));
            Assert.That(run.Said[0].Text, Does.Contain(words).And.Contain("lock"));
        }

        [Test]
        public void PictureMonitor_WholePictureFlashesForAFrame_IsNoExposureChange()
        {
            var run = new MonitorRun();
            run.Play(0, 200, (b, i) => MonitorRun.Room(b, light: i % 40 == 20 ? 1.4f : 1));
            Assert.That(run.Kinds, Is.Empty);
        }

        [Test]
        public void PictureMonitor_OnlyAPartBrighter_IsNoExposureChange()
        {
            var run = new MonitorRun();
            run.Play(0, 200, (b, i) =>
            {
                MonitorRun.Room(b);
                if (i >= 100)
                    b.Box(40, 40, 200, 150, 120, 160, 140);
            });
            Assert.That(run.Kinds, Is.Empty);
        }

        [Test]
        public void PictureMonitor_WhiteBalanceDrifts_IsAColorChange()
        {
            var run = new MonitorRun();
            run.Play(0, 200, (b, i) =>
            {
                float red = i < 100 ? 1 : System.Math.Min(1.15f, 1 + 0.01f * (i - 100));
                b.Wall(60, 70, 65 * red).Box(40, 40, 90, 90, 100, 120, 110 * red).Box(180, 100, 90, 90, 150, 130, 140 * red);
            });
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.ColorChange }));
            Assert.That(run.Said[0].Text, Does.Contain("red").And.Contain("white balance"));
        }

        [TestCase(7, 0)]
        [TestCase(-3, 5)]
        [TestCase(0, -12)]
        public void PictureMonitor_PictureDisplacedForGood_TheCameraWasMoved(int x, int y)
        {
            var run = new MonitorRun();
            run.Play(0, 180, (b, i) =>
            {
                int dx = i < 60 ? 0 : x, dy = i < 60 ? 0 : y;
                MonitorRun.Room(b, dx, dy);
                b.Box(70 + dx, 60 + dy, 180, 120, 200, 220, 210);
            });
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.CameraMoved }));
            Assert.That(run.Said[0].Value, Is.EqualTo(new Vector2D(x, y).Length).Within(0.35));
            Assert.That(run.Said[0].Text, Does.Contain("calibrate again"));
        }

        [Test]
        public void PictureMonitor_CameraShakenForAMoment_IsNotMoved()
        {
            var run = new MonitorRun();
            run.Play(0, 180, (b, i) => MonitorRun.Room(b, i / 3 % 20 == 5 ? 3 : 0));
            Assert.That(run.Kinds, Is.Empty);
        }

        [Test]
        public void PictureMonitor_WarmFrames_AllocateNothing()
        {
            var run = new MonitorRun();
            run.Play(0, 60, (b, i) => MonitorRun.Room(b));
            int next = 60;
            Assert.That(Allocation.Of(() =>
            {
                run.Play(next, 60, (b, i) => MonitorRun.Room(b, 0));
                next += 60;
            }), Is.EqualTo(0));
        }

        [Test]
        public void PictureMonitor_PictureChangesSizeOrIsTiny_GoesOn()
        {
            var run = new MonitorRun();
            using var frame = new Capture.Frame();
            run.Play(0, 5, (b, i) => MonitorRun.Room(b));
            new FrameBuilder(1, 1).Write(frame, 5, 200_000);
            run.Monitor.Process(frame);
            frame.Begin(6, 240_000);
            run.Monitor.Process(frame);
            run.Play(7, 60, (b, i) => MonitorRun.Room(b));
            Assert.That(run.Kinds, Is.Empty);
        }

        [TestCase(double.NaN)]
        [TestCase(0)]
        public void PictureMonitorSettings_OutsideTheirRange_AreRefused(double gamma)
        {
            Assert.That(() => new PictureMonitor(new SessionRecorder(), new PictureMonitorSettings { Gamma = gamma }), Throws.ArgumentException);
        }
    }
}
