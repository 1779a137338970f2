using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class MotionPathTests
    {
        private static readonly Vector3D Travel = new Vector3D(2, 1, 0.5);

        [TestCase(0.0, 0.0)]
        [TestCase(1.0, 0.5)]
        [TestCase(2.0, 1.0)]
        [TestCase(3.0, 0.5)]
        [TestCase(4.0, 0.0)]
        [TestCase(-1.0, 0.5)]
        public void MotionPath_PingPong_GoesThereAndBackAtConstantSpeed(double timeS, double share)
        {
            var path = new MotionPath(MotionKind.PingPong, Travel, 4, 0);
            Assert.That((path.OffsetAt(timeS) - Travel * share).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void MotionPath_Sine_SwingsThroughRest()
        {
            var path = new MotionPath(MotionKind.Sine, Travel, 4, 0);
            Assert.That(path.OffsetAt(0).Length, Is.LessThan(1e-12));
            Assert.That((path.OffsetAt(1) - Travel).Length, Is.LessThan(1e-12));
            Assert.That((path.OffsetAt(3) + Travel).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void MotionPath_Circle_RunsOnTheEllipse()
        {
            var path = new MotionPath(MotionKind.Circle, Travel, 4, 0);
            Assert.That((path.OffsetAt(0) - new Vector3D(2, 0, 0)).Length, Is.LessThan(1e-12));
            Assert.That((path.OffsetAt(1) - new Vector3D(0, 1, 0)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void MotionPath_Phase_ShiftsTime()
        {
            var path = new MotionPath(MotionKind.Sine, Travel, 5, 1.3);
            var plain = new MotionPath(MotionKind.Sine, Travel, 5, 0);
            Assert.That((path.OffsetAt(2) - plain.OffsetAt(3.3)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void MotionPath_PeriodNotAboveZero_IsRefused()
        {
            Assert.That(() => new MotionPath(MotionKind.Sine, Travel, 0, 0), Throws.ArgumentException);
            Assert.That(() => new MotionPath(MotionKind.Circle, Travel, double.NaN, 0), Throws.ArgumentException);
            Assert.That(() => new MotionPath(MotionKind.None, Travel, 0, 0), Throws.Nothing);
        }
    }
}
