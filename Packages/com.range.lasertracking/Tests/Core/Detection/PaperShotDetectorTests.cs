using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class PaperShotDetectorTests
    {
        [Test]
        public void Process_GreenDotOnDarkWall_IsTheBestCandidateOfTheFrame()
        {
            var run = new DetectionRun(new PaperShotDetector());
            run.Play(0, 8, (b, i) => b.Wall(30, 30, 30));
            Assert.That(run.Shots, Is.Empty);
            run.Play(8, 2, (b, i) => b.Wall(30, 30, 30).Dot(151.3, 97.6, 3, 20, 200, 20));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.PositionPx.X, Is.EqualTo(151.3).Within(0.5));
            Assert.That(run.Shots[0].Dot.PositionPx.Y, Is.EqualTo(97.6).Within(0.5));
            Assert.That(run.Shots[0].Dot.Color, Is.EqualTo(LaserColor.Green));
        }

        [Test]
        public void Process_RedDot_HasNoGreenExcess()
        {
            var run = new DetectionRun(new PaperShotDetector());
            run.Play(0, 8, (b, i) => b.Wall(30, 30, 30));
            run.Play(8, 2, (b, i) => b.Wall(30, 30, 30).Dot(151.3, 97.6, 3, 20, 20, 200));
            Assert.That(run.Shots, Is.Empty);
        }

        [Test]
        public void Process_FrameWiderThanTheReduction_GivesFullResolutionCoordinates()
        {
            var run = new DetectionRun(new PaperShotDetector(new PaperDetectorSettings { ReducedWidthPx = 160 }));
            run.Play(0, 8, (b, i) => b.Wall(30, 30, 30));
            run.Play(8, 1, (b, i) => b.Wall(30, 30, 30).Dot(201, 41, 6, 20, 200, 20));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.PositionPx.X, Is.EqualTo(201).Within(1));
            Assert.That(run.Shots[0].Dot.PositionPx.Y, Is.EqualTo(41).Within(1));
        }

        [Test]
        public void Process_CandidateOutsideThePolygon_NeverCounts()
        {
            var run = new DetectionRun(new PaperShotDetector());
            run.Detector.SetScreenPolygon(new[] { new Geometry.Vector2D(0, 0), new Geometry.Vector2D(100, 0), new Geometry.Vector2D(100, 200), new Geometry.Vector2D(0, 200) });
            run.Play(0, 8, (b, i) => b.Wall(30, 30, 30));
            run.Play(8, 1, (b, i) => b.Wall(30, 30, 30).Dot(151, 97, 3, 20, 200, 20));
            Assert.That(run.Shots, Is.Empty);
            Assert.That(run.Rejected.Exists(r => r.Reason == RejectionReason.OutsideScreen), Is.True);
        }

        [Test]
        public void Process_ConfidenceBelowTheLimit_IsRejectedWithValueAndLimit()
        {
            var run = new DetectionRun(new PaperShotDetector(new PaperDetectorSettings { MinConfidence = 0.95 }));
            run.Play(0, 8, (b, i) => b.Wall(30, 30, 30));
            run.Play(8, 1, (b, i) => b.Wall(30, 30, 30).Dot(20, 20, 3, 20, 100, 20));
            Assert.That(run.Shots, Is.Empty);
            RejectedCandidate candidate = run.Rejected.Find(r => r.Reason == RejectionReason.LowConfidence);
            Assert.That(candidate.Limit, Is.EqualTo(0.95));
            Assert.That(candidate.Value, Is.InRange(0.1, 0.95));
        }

        [Test]
        public void Settings_Defaults_AreThePublishedConstants()
        {
            var s = new PaperDetectorSettings();
            Assert.That(new[] { s.BackgroundAlpha, s.SpikeGamma, s.SpikeWeight, s.GreenWeight, s.TopShare, s.MinGreenExcess, s.MinConfidence },
                Is.EqualTo(new[] { 0.95, 0.88, 0.6, 0.4, 0.005, 25, 0.3 }));
            Assert.That(new[] { s.PeakWeight, s.ContrastWeight, s.CenterWeight, s.StabilityWeight }, Is.EqualTo(new[] { 0.4, 0.3, 0.2, 0.1 }));
            Assert.That(s.ReducedWidthPx, Is.EqualTo(960));
        }

        [TestCase(1.5)]
        [TestCase(-0.01)]
        [TestCase(double.NaN)]
        public void Constructor_AlphaOutsideItsRange_IsRefusedByName(double alpha)
        {
            ArgumentException? error = Assert.Throws<ArgumentException>(() => new PaperShotDetector(new PaperDetectorSettings { BackgroundAlpha = alpha }));
            Assert.That(error!.Message, Does.Contain("BackgroundAlpha").And.Contain("0…1"));
        }
    }
}
