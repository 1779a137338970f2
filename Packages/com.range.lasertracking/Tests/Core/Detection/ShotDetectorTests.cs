using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class ShotDetectorTests
    {
        private static FrameBuilder Wall(FrameBuilder b) => b.Wall(90, 100, 110);

        [TestCase(PixelFormat.Bgra32)]
        [TestCase(PixelFormat.Nv12)]
        [TestCase(PixelFormat.Yuy2)]
        public void Process_SaturatedDotOfOneFrame_IsOneGreenShotAtItsPlace(PixelFormat format)
        {
            var run = new DetectionRun { Format = format };
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 1, (b, i) => Wall(b).GreenDot(151.3, 97.6));
            run.Play(9, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Shot shot = run.Shots[0];
            Assert.That(shot.FrameIndex, Is.EqualTo(8), "one frame suffices");
            Assert.That(shot.FirstFrameIndex, Is.EqualTo(8));
            Assert.That(shot.TimeUs, Is.EqualTo(8 * run.IntervalUs));
            Assert.That(shot.Dot.PositionPx.X, Is.EqualTo(151.3).Within(0.15));
            Assert.That(shot.Dot.PositionPx.Y, Is.EqualTo(97.6).Within(0.15));
            Assert.That(shot.Dot.Color, Is.EqualTo(LaserColor.Green));
            Assert.That(shot.Dot.Peak, Is.EqualTo(255));
            Assert.That(shot.Dot.Confidence, Is.InRange(0.5, 1));
        }

        [Test]
        public void Process_DotInTheSecondFrameOfAll_IsAShot()
        {
            var run = new DetectionRun();
            run.Play(0, 5, (picture, i) =>
            {
                picture.Wall(40, 40, 40);
                if (i == 1)
                    picture.GreenDot(100, 80);
            });
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].FirstFrameIndex, Is.EqualTo(1));
        }

        [Test]
        public void Process_RedDot_IsRed()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 1, (b, i) => Wall(b).RedDot(60, 200));
            run.Play(9, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.Color, Is.EqualTo(LaserColor.Red));
        }

        [Test]
        public void Process_ReddishWhiteDot_HasNoColor()
        {
            // Near infrared through the three filters of a colour camera.
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(100, 100, 100));
            run.Play(8, 1, (b, i) => b.Wall(100, 100, 100).Dot(60, 200, 2, 1260, 840, 1400));
            run.Play(9, 6, (b, i) => b.Wall(100, 100, 100));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.Color, Is.EqualTo(LaserColor.Unknown));
        }

        [Test]
        public void Process_UnsaturatedDotOnDarkWall_IsFound()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(20, 22, 20));
            run.Play(8, 2, (b, i) => b.Wall(20, 22, 20).GreenDot(200, 120, 2, 0.08));
            run.Play(10, 6, (b, i) => b.Wall(20, 22, 20));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.Color, Is.EqualTo(LaserColor.Green));
        }

        [TestCase(640, 360)]
        [TestCase(1920, 1080)]
        public void Process_DotOfAFewPixels_IsFoundWhateverThePicturesSize(int width, int height)
        {
            var run = new DetectionRun(null, width, height);
            run.Play(0, 8, (b, i) => b.Wall(20, 22, 20));
            run.Play(8, 1, (b, i) => b.Wall(20, 22, 20).GreenDot(200.4, 120.2, 0.8, 0.1));
            run.Play(9, 6, (b, i) => b.Wall(20, 22, 20));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That((run.Shots[0].Dot.PositionPx - new Vector2D(200.4, 120.2)).Length, Is.LessThan(0.3));
        }

        [Test]
        [Category("Long")]
        public void Process_DotWhoseFirstFrameIsFaint_IsWeighedAgainInTheChannelThatGrew([Values(0.01, 0.02, 0.03, 0.04)] double first, [Values(1u, 2u, 4u, 27u)] uint seed)
        {
            var run = new DetectionRun(null, 640, 360, seed: seed * 2654435761);
            FrameBuilder Picture(FrameBuilder b) => b.Wall(60, 62, 60).Box(400, 60, 200, 240, 215, 215, 215);
            run.Play(0, 8, (b, i) => Picture(b));
            run.Play(8, 1, (b, i) => Picture(b).GreenDot(200.4, 120.2, 1, first));
            run.Play(9, 20, (b, i) => Picture(b).GreenDot(200.4, 120.2, 1, 0.1));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [TestCase(0.13, 1.2, 0.08, 1.2, TestName = "brighter than the picture in every second frame")]
        [TestCase(0.12, 0.7, 0.08, 1.8, TestName = "three pixels and twenty in turn")]
        public void Process_DotThatSpeckleChanges_IsOneShot(double strength, double sigma, double otherStrength, double otherSigma)
        {
            var run = new DetectionRun(null, 640, 360);
            FrameBuilder Picture(FrameBuilder b) => b.Wall(60, 62, 60).Box(400, 60, 200, 240, 190, 190, 190);
            run.Play(0, 8, (b, i) => Picture(b));
            run.Play(8, 10, (b, i) => Picture(b).GreenDot(200.4, 120.2, i % 2 == 0 ? sigma : otherSigma, i % 2 == 0 ? strength : otherStrength));
            run.Play(18, 20, (b, i) => Picture(b));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [TestCase(5, true, 1)]
        [TestCase(8, false, 1)]
        [TestCase(8, true, 0)]
        public void Process_DoubtfulLight_IsAShotIfItGoesOutInTimeAndSoonerAmidMovement(int frames, bool isMoving, int shots)
        {
            var run = new DetectionRun(null, 640, 360);
            FrameBuilder Picture(FrameBuilder b, int i) =>
                b.Wall(60, 62, 60).Box(400, 60, 200, 240, 190, 190, 190).Box(isMoving ? 150 + 3 * (i % 12) : 150, 130, 30, 30, 100, 100, 100);
            run.Play(0, 20, (b, i) => Picture(b, i));
            run.Play(20, frames, (b, i) => Picture(b, i).GreenDot(200.4, 115.2, 1.5, 0.06));
            run.Play(20 + frames, 20, (b, i) => Picture(b, i));
            Assert.That(run.Shots.Count, Is.EqualTo(shots));
        }

        [Test]
        public void Process_PixelThatFlickers_IsNoShot()
        {
            var run = new DetectionRun(null, 640, 360);
            run.Play(0, 60, (b, i) => b.Wall(20, 22, 20).Box(200, 120, i % 20 == 15 ? 1 : 0, 1, 40, 250, 30));
            Assert.That(run.Shots, Is.Empty);
            Assert.That(run.Rejected.Exists(r => r.Reason == RejectionReason.TooSmall), Is.True);
        }

        [TestCase(0.0, 0)]
        [TestCase(40.0, 1)]
        public void Process_FaintGlow_CountsUnlessItsSourceLiesOutsideThePicture(double x, int shots)
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(20, 22, 20));
            run.Play(8, 1, (b, i) => b.Wall(20, 22, 20).RedDot(x, 120, 4, 0.05));
            run.Play(9, 8, (b, i) => b.Wall(20, 22, 20));
            Assert.That(run.Shots.Count, Is.EqualTo(shots));
        }

        [Test]
        public void Process_Streak_IsOneShotWithItsVector()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 1, (b, i) => Wall(b).GreenStreak(100, 100, 124, 110));
            run.Play(9, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Dot dot = run.Shots[0].Dot;
            Assert.That(dot.PositionPx.X, Is.EqualTo(112).Within(1));
            Assert.That(dot.PositionPx.Y, Is.EqualTo(105).Within(1));
            Assert.That(dot.StreakPx.Length, Is.EqualTo(26).Within(6));
            Assert.That(Math.Abs(dot.StreakPx.Y / dot.StreakPx.X), Is.EqualTo(10.0 / 24).Within(0.1));
        }

        [Test]
        public void Process_DotThatStaysOn_IsOneShotAndThenATrackedDot()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            for (int i = 8; i < 40; i++)
            {
                int dots = run.Play(i, 1, (b, n) => Wall(b).GreenDot(151.3, 97.6));
                Assert.That(dots, Is.EqualTo(1), "frame " + i);
            }

            Assert.That(run.Play(40, 1, (b, i) => Wall(b)), Is.EqualTo(0));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_DoubleTapATenthOfASecondApart_AreTwoShots()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 1, (b, i) => Wall(b).GreenDot(151, 97));
            run.Play(9, 2, (b, i) => Wall(b));
            run.Play(11, 1, (b, i) => Wall(b).GreenDot(152, 98));
            run.Play(12, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(2));
            Assert.That(run.Shots[1].FrameIndex, Is.EqualTo(11));
        }

        [TestCase(4, 2, 2)]
        [TestCase(5, 1, 2)]
        [TestCase(2, 1, 1, TestName = "a flash that flickers is one")]
        public void Process_LongFlashesATenthOfASecondApartAtSixtyFrames_AreTwoShots(int lit, int dark, int shots)
        {
            var run = new DetectionRun(framesPerSecond: 60);
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, lit, (b, i) => Wall(b).GreenDot(151, 97));
            run.Play(8 + lit, dark, (b, i) => Wall(b));
            run.Play(8 + lit + dark, lit, (b, i) => Wall(b).GreenDot(152, 98));
            run.Play(8 + 2 * lit + dark, 12, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(shots));
        }

        [Test]
        public void Process_TwoLasersAtOnce_AreTwoShots()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 2, (b, i) => Wall(b).GreenDot(100, 97).RedDot(125, 110));
            run.Play(10, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(2));
            Assert.That(run.Shots[0].Dot.Color, Is.Not.EqualTo(run.Shots[1].Dot.Color));
        }

        [Test]
        public void Process_WholePictureFlash_IsNoShot()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 1, (b, i) => Wall(b).Multiply(1.8f));
            run.Play(9, 6, (b, i) => Wall(b));
            Assert.That(run.Shots, Is.Empty);
        }

        [TestCase(1.05f)]
        [TestCase(1.4f)]
        public void Process_ExposureSteps_GiveNoShots(float gain)
        {
            var run = new DetectionRun();
            run.Play(0, 60, (b, i) => Wall(b).Box(100, 60, 40, 60, 180, 180, 180).Multiply(i / 10 % 2 == 0 ? 1 : gain));
            Assert.That(run.Shots, Is.Empty);
        }

        [Test]
        public void Process_MovingShapes_GiveNoShotsAndADotBesideThemDoes()
        {
            var run = new DetectionRun();
            run.Play(0, 40, (b, i) => Shapes(Wall(b), i));
            Assert.That(run.Shots, Is.Empty);
            run.Play(40, 1, (b, i) => Shapes(Wall(b), i).GreenDot(290, 210));
            run.Play(41, 6, (b, i) => Shapes(Wall(b), i));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_HalfThePictureFlickers_SaysHowMuchIsBlind()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => Wall(b));
            Assert.That(run.Detections.BlindShare, Is.EqualTo(0));
            var random = new Random(3);
            run.Play(8, 40, (b, i) => Flicker(Wall(b), random));
            Assert.That(run.Detections.BlindShare, Is.InRange(0.3, 0.7));
            run.Play(48, 1, (b, i) => Flicker(Wall(b).GreenDot(80, 120), random));
            Assert.That(run.Shots.Exists(s => s.FirstFrameIndex == 48 && Math.Abs(s.Dot.PositionPx.X - 80) < 1), Is.True, "the quiet half still sees");
        }

        [Test]
        public void Process_NoiseOnly_GivesNoShots()
        {
            foreach (double sigma in new[] { 1.0, 4.0, 8.0 })
            {
                var run = new DetectionRun();
                run.Builder.NoiseSigma = sigma;
                run.Play(0, 60, (b, i) => Wall(b));
                Assert.That(run.Shots, Is.Empty, "sigma " + sigma);
            }
        }

        [Test]
        public void Process_NoisyPicture_StillShowsTheDot()
        {
            var run = new DetectionRun();
            run.Builder.NoiseSigma = 6;
            run.Play(0, 20, (b, i) => Wall(b));
            run.Play(20, 2, (b, i) => Wall(b).GreenDot(151.3, 97.6));
            run.Play(22, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void SetScreenPolygon_DotOutside_IsRejectedWithItsDistance()
        {
            var run = new DetectionRun();
            run.Detector.SetScreenPolygon(new[] { P(20, 20), P(200, 20), P(200, 200), P(20, 200) });
            run.Play(0, 8, (b, i) => Wall(b));
            run.Play(8, 1, (b, i) => Wall(b).GreenDot(230, 100).GreenDot(100, 100));
            run.Play(9, 6, (b, i) => Wall(b));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.PositionPx.X, Is.EqualTo(100).Within(1));
            RejectedCandidate outside = run.Rejected.Find(r => r.Reason == RejectionReason.OutsideScreen);
            Assert.That(outside.Value, Is.EqualTo(30).Within(1));
            Assert.That(outside.Limit, Is.EqualTo(0));
        }

        /// <summary>White specks all over the right half, elsewhere in every frame.</summary>
        private static FrameBuilder Flicker(FrameBuilder b, Random random)
        {
            for (int i = 0; i < 500; i++)
                b.Box(160 + random.Next(160), random.Next(240), 2, 2, 255, 255, 255);
            return b;
        }

        private static FrameBuilder Shapes(FrameBuilder b, int i) => b
            .Box(40 + 5 * i % 120, 60, 30, 30, 245, 245, 245)
            .Box(60, 30 + 4 * i % 100, 36, 24, 30, 40, 250)
            .Box(150 - 3 * i % 80, 160, 60, 14, 60, 240, 250);

        private static Geometry.Vector2D P(double x, double y) => new Geometry.Vector2D(x, y);
    }
}
