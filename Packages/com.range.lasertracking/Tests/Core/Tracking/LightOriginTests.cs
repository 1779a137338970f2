using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    public sealed class LightOriginTests
    {
        private const long IntervalUs = 33_333;

        [Test]
        public void RowTimeUs_RollingShutter_IsThatOfTheDotsRow()
        {
            var origin = new LightOrigin(new CameraTimingSettings { RowUs = 20 }, 10);
            var frame = new Detections();
            frame.Begin(4, 1_000_000);
            frame.ImageHeightPx = 721;
            Assert.That(origin.RowTimeUs(frame, DotAt(50, 360)), Is.EqualTo(1_000_000));
            Assert.That(origin.RowTimeUs(frame, DotAt(50, 460)), Is.EqualTo(1_002_000));
            Assert.That(origin.RowTimeUs(frame, DotAt(50, 260)), Is.EqualTo(998_000));
        }

        [Test]
        public void SigmaUs_OpenShutter_IsAnEvenSpreadOverTheInterval()
        {
            Assert.That(Origin(IntervalUs).SigmaUs(IntervalUs), Is.EqualTo(IntervalUs / Math.Sqrt(12)).Within(1));
        }

        [TestCase(2_000)]
        [TestCase(16_667)]
        public void SigmaUs_ClosedShutter_IsTheDistanceOfTheBeginFromMidExposure(double exposureUs)
        {
            // Begins from the end of the exposure before to the end of this one, by brute force.
            double sum = 0, from = exposureUs / 2 - IntervalUs;
            for (int i = 0; i < 10_000; i++)
            {
                double begin = from + (i + 0.5) / 10_000 * IntervalUs;
                sum += begin * begin / 10_000;
            }

            Assert.That(Origin(exposureUs).SigmaUs(IntervalUs), Is.EqualTo(Math.Sqrt(sum)).Within(5));
        }

        [Test]
        public void SigmaUs_UnknownShutter_LiesBetweenOpenAndFlash()
        {
            long unknown = Origin(0).SigmaUs(IntervalUs);
            Assert.That(unknown, Is.GreaterThan(Origin(IntervalUs).SigmaUs(IntervalUs)).And.LessThan(Origin(100).SigmaUs(IntervalUs)));
        }

        [Test]
        public void Place_StreakOfWhichNothingElseIsKnown_StaysHalfWayAndHoldsBothEnds()
        {
            Dot dot = Streak();
            Origin(IntervalUs).Place(ref dot, default, IntervalUs, 1);
            Assert.That(dot.PositionPx, Is.EqualTo(new Vector2D(100, 80)));
            Assert.That(IsInside90(dot.CovariancePx, new Vector2D(9.8, 0)), Is.True);
            Assert.That(IsInside90(dot.CovariancePx, new Vector2D(14, 0)), Is.False);
            Assert.That(IsInside90(dot.CovariancePx, new Vector2D(0, 6)), Is.False);
        }

        [TestCase(15, 90)]
        [TestCase(-15, 110)]
        public void Place_StreakThatGoesOn_BeganAtTheEndAwayFromWhereItWent(double wayX, double beganX)
        {
            Dot dot = Streak();
            Origin(IntervalUs).Place(ref dot, new Vector2D(wayX, 1), IntervalUs, 1);
            Assert.That(dot.PositionPx.X, Is.EqualTo(beganX).Within(0.1));
            Assert.That(Math.Sign(dot.StreakPx.X), Is.EqualTo(Math.Sign(wayX)));
            Assert.That(dot.StreakPx.Length, Is.EqualTo(20).Within(0.1));
        }

        [Test]
        public void Place_ShortShutter_LeavesMoreRoomThanAnOpenOne()
        {
            Dot open = DotAt(100, 80), shut = DotAt(100, 80);
            Origin(IntervalUs).Place(ref open, default, IntervalUs, 1);
            Origin(1000).Place(ref shut, default, IntervalUs, 1);
            Assert.That(shut.CovariancePx.Sigma, Is.GreaterThan(open.CovariancePx.Sigma));
            Assert.That(open.CovariancePx.Sigma, Is.GreaterThan(DotAt(100, 80).CovariancePx.Sigma));
        }

        [TestCase(-1, 0)]
        [TestCase(double.NaN, 0)]
        [TestCase(2e6, 0)]
        [TestCase(0, double.NaN)]
        [TestCase(0, 5000)]
        public void Validate_TimingOutOfRange_IsRefused(double exposureUs, double rowUs)
        {
            var settings = new ShotTrackerSettings { Timing = new CameraTimingSettings { ExposureUs = exposureUs, RowUs = rowUs } };
            Assert.Throws<ArgumentException>(() => new ShotTracker(settings));
        }

        private static LightOrigin Origin(double exposureUs) => new LightOrigin(new CameraTimingSettings { ExposureUs = exposureUs }, 10);

        private static Dot DotAt(double x, double y) => new Dot { PositionPx = new Vector2D(x, y), CovariancePx = Covariance2D.Isotropic(0.1) };

        /// <summary>20 px long, along x.</summary>
        private static Dot Streak()
        {
            Dot dot = DotAt(100, 80);
            dot.ShapePx = new Covariance2D(1 + 402 / 12.0, 0, 1);
            dot.StreakPx = DotStreak.From(dot.ShapePx, out _);
            return dot;
        }

        private static bool IsInside90(in Covariance2D c, Vector2D e) =>
            (c.YY * e.X * e.X - 2 * c.XY * e.X * e.Y + c.XX * e.Y * e.Y) / (c.XX * c.YY - c.XY * c.XY) <= 4.605;
    }
}
