using System.Linq;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Host.Studies.Simulated;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Studies
{
    public sealed class SimulatedRunTests
    {
        [Test]
        public void SimulatedRun_OneStrongAndOneInvisibleShot_AreToldApart()
        {
            var scenario = new SimulationScenario { DurationS = 2 };
            (scenario.ColorCamera.Width, scenario.ColorCamera.Height) = (320, 180);
            (scenario.Projector.Width, scenario.Projector.Height) = (320, 180);
            scenario.DepthCamera.Enabled = false;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shooters[0].Laser.PowerMw = 5;
            scenario.Shooters[1].Laser.PowerMw = 1e-5;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.8, PulseMs = 60, Shooter = 1, ScreenM = new Vector2D(1.2, 0.5) });
            scenario.Shots.Add(new ShotSettings { TimeS = 1.3, PulseMs = 60, Shooter = 2, ScreenM = new Vector2D(2.2, 1.2) });
            var run = new SimulatedRun(new SimulatedRange(scenario, StillCase.Still(SimulationScenes.Default())));
            run.Process(CancellationToken.None);
            Assert.That(run.Shots.Select(s => s.IsFound), Is.EqualTo(new[] { true, false }));
            Assert.That(run.Shots[0].RiseOfAll, Is.GreaterThan(0.6));
            Assert.That(run.Shots[1].Rise, Is.LessThan(0.1));
            Assert.That(run.False, Is.Empty);
            Assert.That(run.Doubles, Is.Empty);
        }

        [Test]
        public void StillCase_SameSeed_GivesTheSameShots()
        {
            SimulatedRange a = StillCase.All()[0].Create(7, 20), b = StillCase.All()[0].Create(7, 20);
            Assert.That(a.Truth.Shots.Count, Is.GreaterThan(8));
            Assert.That(b.Truth.Shots.Select(s => s.FirstLightPx), Is.EqualTo(a.Truth.Shots.Select(s => s.FirstLightPx)));
            Assert.That(StillCase.All()[0].Create(8, 20).Truth.Shots.Select(s => s.FirstLightPx), Is.Not.EqualTo(a.Truth.Shots.Select(s => s.FirstLightPx)));
        }
    }
}
