using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Lasers that rest while the picture behind them changes, content unknown.</summary>
    public sealed class RestingDotsTests
    {
        private const int FramesPerSecond = 30;

        [TestCase(7)]
        [TestCase(8)]
        [TestCase(28)]
        [TestCase(47)]
        [Category("Long")]
        public void Dot_ThatRestsWhileUnknownPicturesMove_IsOneShotAndStaysADot(int seed)
        {
            SimulationScenario scenario = MovingRange.Scenario(seed, 9);
            scenario.Shots.Add(new ShotSettings { TimeS = 2.5, PulseMs = 6000, ScreenM = new Vector2D(1.4, 0.8) });
            var range = new MovingRange(scenario);
            range.PlayAndCount(false, out int shown, out int seen);
            Assert.That(range.Shots.Count(s => s.FirstFrameIndex > 2 * FramesPerSecond), Is.EqualTo(1));
            Assert.That(shown, Is.GreaterThan(170));
            Assert.That(seen, Is.GreaterThanOrEqualTo(0.95 * shown));
        }

        [Test]
        public void Dot_ThatGoesOutOnABrightSpeck_IsNotTakenForTheSpeck()
        {
            var run = new DetectionRun();
            run.Play(0, 90, (b, i) =>
            {
                b.Wall(50, 50, 50).Box(98, 105, 5, 5, 150, 160, 160);
                bool isHeld = i >= 20 && i < 27, isTap = i == 50 || i == 51;
                if (isHeld || isTap)
                    b.RedDot(100, 107, 1.8, 0.5);
            });
            Assert.That(run.Shots.Select(s => s.FirstFrameIndex), Is.EqualTo(new[] { 20, 50 }));
        }
    }
}
