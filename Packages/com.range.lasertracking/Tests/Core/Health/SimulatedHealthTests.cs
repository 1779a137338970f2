using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Session;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Health
{
    /// <summary>The checks on simulated rooms, where light behaves as light.</summary>
    public sealed class SimulatedHealthTests
    {
        [TestCase(100.0, 30.0, 0.0, 5000.0, "50 Hz", "10 or 20 ms")]
        [TestCase(100.0, 30.0, 40.0, 5000.0, "50 Hz", "10 or 20 ms")]
        [TestCase(120.0, 25.0, 60.0, 4000.0, "60 Hz", "8.33 or 16.67 ms")]
        [TestCase(100.0, 60.0, 20.0, 6000.0, "50 Hz", "set the exposure to 10 ms")]
        [Category("Long")]
        public void PictureMonitor_LampsOnMains_AreNamedWithTheExposureToChoose(double hz, double rate, double rowUs, double exposureUs, string mains, string advice)
        {
            SimulationScenario scenario = Room(rate);
            scenario.ColorCamera.ExposureUs = exposureUs;
            scenario.ColorCamera.RollingShutterRowUs = rowUs;
            scenario.Room.Ambient = 0.3;
            scenario.Room.FlickerDepth = 0.5;
            scenario.Room.FlickerHz = hz;
            MonitorRun run = new MonitorRun().Play(scenario);
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.Flicker }), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(run.Said[0].Text, Does.Contain(mains).And.Contain(advice).And.Contain(rowUs > 0 ? "bands" : "whole picture"));
        }

        [Test]
        [Category("Long")]
        public void PictureMonitor_ExposureOfWholeMainsPeriods_DoesNotFlicker()
        {
            SimulationScenario scenario = Room(30);
            scenario.ColorCamera.ExposureUs = 10_000;
            scenario.Room.Ambient = 0.3;
            scenario.Room.FlickerDepth = 0.5;
            Assert.That(new MonitorRun().Play(scenario).Said.Select(h => h.Text), Is.Empty);
        }

        [Test]
        [Category("Long")]
        public void PictureMonitor_AutomaticExposureSettles_IsSaidOnce()
        {
            SimulationScenario scenario = Room(30);
            scenario.Room.Ambient = 0.2;
            scenario.ColorCamera.ExposureSteps.Add(new ExposureStepSettings { TimeS = 2, Factor = 0.5, SettleS = 0.7 });
            MonitorRun run = new MonitorRun().Play(scenario);
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.ExposureChange }), string.Join("; ", run.Said.Select(h => h.Text)));
        }

        [Test]
        [Category("Long")]
        public void PictureMonitor_NudgedCamera_IsMovedByThatMuch()
        {
            SimulationScenario scenario = Room(30);
            scenario.Room.Ambient = 0.2;
            scenario.Nudges.Add(new NudgeSettings { TimeS = 2, ShiftPx = new Vector2D(4, -3) });
            MonitorRun run = new MonitorRun().Play(scenario);
            Assert.That(run.Kinds, Is.EqualTo(new[] { HealthKind.CameraMoved }), string.Join("; ", run.Said.Select(h => h.Text)));
            Assert.That(run.Said[0].Value, Is.EqualTo(5).Within(0.5));
            Assert.That(run.Said[0].TimeUs, Is.LessThan(4_000_000), "noticed within two seconds");
        }

        [TestCase(0.0)]
        [TestCase(0.05)]
        [Category("Long")]
        public void PictureMonitor_OrdinaryMovingScene_SaysNothing(double ambient)
        {
            SimulationScenario scenario = Room(30);
            scenario.Room.Ambient = ambient;
            scenario.Generator.ShotsPerMinute = 60;
            Assert.That(new MonitorRun().Play(scenario).Said.Select(h => h.Text), Is.Empty);
        }

        private static SimulationScenario Room(double framesPerSecond)
        {
            var scenario = new SimulationScenario { Seed = 3, DurationS = 5 };
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.ColorCamera.FramesPerSecond = framesPerSecond;
            scenario.ColorCamera.ExposureUs = System.Math.Min(16_670, 1e6 / framesPerSecond);
            scenario.DepthCamera.Enabled = false;
            scenario.Shooters.Add(new ShooterSettings());
            return scenario;
        }
    }
}
