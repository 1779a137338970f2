using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class DotLocatorTests
    {
        private static readonly double[] Phases = { 0, 0.17, 0.33, 0.5, 0.71, 0.9 };

        [TestCase(PixelFormat.Bgra32, 0.06, 0.08)]
        [TestCase(PixelFormat.Nv12, 0.06, 0.08)]
        [TestCase(PixelFormat.Yuy2, 0.06, 0.08)]
        [TestCase(PixelFormat.Bgra32, 2, 0.05)]
        public void Locate_DotBetweenPixels_IsWithinAFewHundredthsOfItsCentre(PixelFormat format, double strength, double limitPx)
        {
            double sum = 0;
            foreach (double phase in Phases)
                sum += (Locate(format, 100 + phase, 80 + 0.37 * phase, strength, (b, x, y) => b.Wall(25, 25, 25)).PositionPx - new Vector2D(100 + phase, 80 + 0.37 * phase)).Length;
            Assert.That(sum / Phases.Length, Is.LessThan(limitPx));
        }

        [Test]
        public void Locate_DotOnAnEdge_IsNotDrawnToTheBrightSide()
        {
            Dot dot = Locate(PixelFormat.Bgra32, 100.4, 80.2, 0.08, (b, x, y) => b.Wall(20, 20, 20).Box(101, 0, 60, 240, 70, 70, 70));
            Assert.That((dot.PositionPx - new Vector2D(100.4, 80.2)).Length, Is.LessThan(0.15));
        }

        [Test]
        public void Locate_NoisierPicture_HasTheLargerCovariance()
        {
            Dot quiet = Locate(PixelFormat.Bgra32, 100.4, 80.2, 0.08, (b, x, y) => b.Wall(25, 25, 25), 1);
            Dot noisy = Locate(PixelFormat.Bgra32, 100.4, 80.2, 0.08, (b, x, y) => b.Wall(25, 25, 25), 4);
            Assert.That(noisy.CovariancePx.Sigma, Is.GreaterThan(1.1 * quiet.CovariancePx.Sigma));
            Assert.That(quiet.CovariancePx.Sigma, Is.InRange(0.02, 0.2));
        }

        [Test]
        public void Locate_OvalDot_IsNoStreak()
        {
            Dot dot = Locate(PixelFormat.Bgra32, 100, 80, 1, (b, x, y) => b.Wall(25, 25, 25));
            Assert.That(dot.StreakPx, Is.EqualTo(default(Vector2D)));
            Assert.That(DotStreak.From(new Covariance2D(2, 0, 1.4), out bool isDistinct).Length, Is.LessThan(3));
            Assert.That(isDistinct, Is.False);
        }

        [TestCase(10, 0)]
        [TestCase(24, 10)]
        [TestCase(0, 30)]
        public void From_ShapeOfALine_HasItsLengthAndDirection(double x, double y)
        {
            double length2 = x * x + y * y;
            Vector2D streak = DotStreak.From(new Covariance2D(1 + x * x / 12, x * y / 12, 1 + y * y / 12), out bool isDistinct);
            Assert.That(isDistinct, Is.True);
            Assert.That(streak.Length, Is.EqualTo(Math.Sqrt(length2)).Within(0.2));
            Assert.That(Math.Abs(Vector2D.Cross(streak, new Vector2D(x, y))), Is.LessThan(0.01 * length2));
        }

        private static Dot Locate(PixelFormat format, double x, double y, double strength, Func<FrameBuilder, double, double, FrameBuilder> wall, double noise = 1)
        {
            var run = new DetectionRun { Format = format };
            run.Builder.NoiseSigma = noise;
            run.Play(0, 8, (b, i) => wall(b, x, y));
            run.Play(8, 1, (b, i) => wall(b, x, y).GreenDot(x, y, 1.6, strength));
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            return run.Detections.Dots[0];
        }
    }
}
