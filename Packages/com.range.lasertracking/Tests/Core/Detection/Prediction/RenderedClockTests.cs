using LaserTracking.Capture;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class RenderedClockTests
    {
        [TestCase(0)]
        [TestCase(7_654_321)]
        [TestCase(-123_000_000)]
        [Category("Long")]
        public void TryFind_PicturesOnAnotherClock_FindsTheDifferenceAndTheDelay(long offsetUs)
        {
            SimulationScenario scenario = MovingRange.Scenario(1, 6);
            scenario.Projector.DelayMs = 45;
            Assert.That(TryFind(new MovingRange(scenario), offsetUs, out long found, out _), Is.True);
            Assert.That(found, Is.EqualTo(offsetUs + 45_000).Within(20_000));
        }

        [Test]
        [Category("Long")]
        public void TryFind_OtherPictures_FindsNothing()
        {
            var range = new MovingRange(MovingRange.Scenario(2, 6), MovingRange.Scenario(3, 6));
            Assert.That(TryFind(range, 0, out _, out double correlation), Is.False);
            Assert.That(correlation, Is.LessThan(0.4));
        }

        [Test]
        public void TryFind_NothingMoves_FindsNothing()
        {
            Assert.That(TryFind(new MovingRange(MovingRange.Scenario(4, 2, ProjectedContent.Bay)), 0, out _, out _), Is.False);
        }

        private static bool TryFind(MovingRange range, long offsetUs, out long found, out double correlation)
        {
            var clock = new RenderedClock(range.Calibration);
            using var frame = new Frame();
            using (IFrameSource pictures = range.CreatePictures())
            {
                while (pictures.TryRead(frame))
                    clock.AddPicture(frame.Color, frame.TimeUs - offsetUs);
            }

            using (IFrameSource camera = range.CreateCamera())
            {
                while (camera.TryRead(frame))
                    clock.AddCameraFrame(frame.Color, frame.TimeUs);
            }

            return clock.TryFind(0.4, out found, out correlation);
        }
    }
}
