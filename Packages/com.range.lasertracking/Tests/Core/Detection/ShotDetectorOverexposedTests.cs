using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Pictures near full brightness, and what only looks like new light.</summary>
    public sealed class ShotDetectorOverexposedTests
    {
        /// <summary>The wall as over-exposed cameras show it: two channels at their limit, little room in the third.</summary>
        [TestCase(215, 300, 300)]
        [TestCase(300, 300, 225)]
        public void ShotDetector_DotWhereOneChannelHasRoom_IsOneShot(float blue, float green, float red)
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(blue, green, red));
            run.Play(8, 2, (b, i) => b.Wall(blue, green, red).Dot(100, 120, 2.5, 200, 700, 200));
            run.Play(10, 8, (b, i) => b.Wall(blue, green, red));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.PositionPx.X, Is.EqualTo(100).Within(0.5));
            Assert.That(run.Shots[0].Dot.PositionPx.Y, Is.EqualTo(120).Within(0.5));
        }

        [Test]
        public void ShotDetector_SpotOfBlueAlone_IsNoShot()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(60, 90, 110));
            run.Play(8, 1, (b, i) => b.Wall(60, 90, 110).Dot(100, 120, 2, 80, 5, 8));
            run.Play(9, 8, (b, i) => b.Wall(60, 90, 110));
            Assert.That(run.Shots, Is.Empty);
        }

        [Test]
        public void ShotDetector_FaintSpotThatWanders_IsNoShotOnceItIsThere()
        {
            // It has come in behind the camera's first frames; three pixels a frame, then it is gone.
            var run = new DetectionRun();
            run.Play(0, 40, (b, i) => b.Wall(40, 60, 100).Dot(60 + 3 * i, 120, 2, 20, 25, 22));
            run.Play(40, 8, (b, i) => b.Wall(40, 60, 100));
            Assert.That(run.Shots, Is.Empty);
        }

        [Test]
        public void ShotDetector_FaintBeginningOfAStrongFlash_IsOneShot()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(60, 90, 110));
            run.Play(8, 1, (b, i) => b.Wall(60, 90, 110).GreenDot(100, 120, 1.5, 0.03));
            run.Play(9, 1, (b, i) => b.Wall(60, 90, 110).GreenDot(101, 120));
            run.Play(10, 8, (b, i) => b.Wall(60, 90, 110));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }
    }
}
