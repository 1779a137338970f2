using System;
using NUnit.Framework;

namespace LaserTracking.Pipeline
{
    public sealed class SceneClockTests
    {
        [Test]
        public void SceneClock_PlayedInTime_GoesWithTheEngine()
        {
            var clock = new SceneClock(false, 0);
            clock.Begin(10, 2);
            clock.Advance(10.5, 2.6, isWorking: false);
            Assert.That(clock.TimeS, Is.EqualTo(2.5).Within(1e-12));
            Assert.That(clock.OffsetS, Is.EqualTo(-8).Within(1e-12));
        }

        [Test]
        public void SceneClock_MachineThatCannotKeepUp_WaitsAndThenGoesOn()
        {
            var clock = new SceneClock(false, 0);
            clock.Begin(0, 0);
            double last = 0;
            for (int i = 1; i <= 100; i++)
            {
                // Frames are worked at at half the speed of the engine.
                clock.Advance(i * 0.1, i * 0.05, isWorking: true);
                Assert.That(clock.TimeS, Is.GreaterThanOrEqualTo(last).And.LessThanOrEqualTo(i * 0.05 + SceneClock.MostAheadS + 1e-9));
                last = clock.TimeS;
            }

            clock.Advance(10.1, 5.1, isWorking: false);
            Assert.That(clock.TimeS, Is.EqualTo(last + 0.1).Within(1e-9));
        }

        [Test]
        public void SceneClock_LiveFirstFrameThatCameLate_IsMadeGoodByTheNext()
        {
            var clock = new SceneClock(true, 0.1);
            clock.Begin(10.6, 0);
            clock.Advance(10.62, 0.55, isWorking: true);
            Assert.That(clock.TimeS, Is.EqualTo(0.65).Within(1e-12), "it had waited for half a second");
        }

        [TestCase(1.0 + 100e-6)]
        [TestCase(1.0 - 100e-6)]
        public void SceneClock_LiveCameraWhoseQuartzDrifts_IsFollowedWithinMilliseconds(double rate)
        {
            const double LatencyS = 0.08;
            var clock = new SceneClock(true, LatencyS);
            var random = new Random(5);
            double last = double.NegativeInfinity, worst = 0;
            clock.Begin(100, -LatencyS);
            for (int i = 1; i < 60 * 600; i++)
            {
                double engineS = 100 + i / 60.0, cameraS = (engineS - 100) * rate;
                // The newest frame came within the last frame interval, now and then much later.
                double newestS = cameraS - LatencyS - random.NextDouble() * 0.033 - (random.Next(50) == 0 ? 0.2 : 0);
                clock.Advance(engineS, newestS, isWorking: true);
                Assert.That(clock.TimeS, Is.GreaterThan(last), "never back");
                last = clock.TimeS;
                if (i > 60 * 30)
                    worst = Math.Max(worst, Math.Abs(clock.TimeS - cameraS));
            }

            Assert.That(worst, Is.LessThan(0.006), "ten minutes of drift alone would be 60 ms");
        }
    }
}
