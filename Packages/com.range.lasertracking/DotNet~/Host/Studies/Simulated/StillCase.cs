using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>A still picture on a wall, seen by a camera, with shots of very different lasers.</summary>
    /// <param name="Name">For the table.</param>
    /// <param name="Apply">What makes it different from the usual room.</param>
    internal sealed record StillCase(string Name, Action<SimulationScenario> Apply)
    {
        private const int Lasers = 24;
        private const double SecondsBetweenShots = 1.5;

        public static StillCase[] All() =>
        [
            new("usual", _ => { }),
            new("dim projector", s => s.Projector.Brightness = 0.35),
            new("bright projector", s => s.Projector.Brightness = 1.7),
            new("over-exposed", s => s.Projector.Brightness = 4),
            new("washed out", s => (s.Projector.BlackLevel, s.Room.Ambient) = (0.4, 0.2)),
            new("projector off", s => (s.Projector.Brightness, s.Room.Ambient) = (0.01, 0.02)),
            new("high gain, noisy", s => (s.ColorCamera.Gain, s.ColorCamera.ExposureUs) = (8, 2000)),
            new("flickering lamps", s => (s.Room.Ambient, s.Room.FlickerDepth, s.ColorCamera.RollingShutterRowUs, s.ColorCamera.ExposureUs) = (0.3, 0.4, 40, 12000)),
        ];

        /// <summary>A session of this length; equal seeds give equal sessions.</summary>
        public SimulatedRange Create(int seed, double durationS)
        {
            var scenario = new SimulationScenario { Name = Name, Seed = seed, DurationS = durationS };
            (scenario.ColorCamera.Width, scenario.ColorCamera.Height) = (640, 360);
            (scenario.Projector.Width, scenario.Projector.Height) = (640, 360);
            scenario.DepthCamera.Enabled = false;
            Apply(scenario);
            SceneModel scene = Still(SimulationScenes.Default());
            AddShots(scenario, scene.ScreenSizeM, seed, SecondsBetweenShots);
            return new SimulatedRange(scenario, scene);
        }

        /// <summary>The same scene with everything at rest.</summary>
        public static SceneModel Still(SceneModel scene) => new(scene.Name + ", still", scene.Surface, scene.ScreenSizeM, scene.Viewpoint, scene.LayerMask,
            scene.Objects.Select(o => new SceneObject(o.Name, o.Layer, o.RestPose, o.Scale, Rotation3D.Identity, default(MotionPath), o.Colliders.ToArray(), o.Target)).ToArray());

        /// <summary>Lasers of 0.01 to 5 mW, red and green, pulses of 5 to 300 ms (both evenly in the logarithm), anywhere on the screen, one after the other.</summary>
        public static void AddShots(SimulationScenario scenario, Vector2D screenM, int seed, double secondsBetween)
        {
            var random = new Random(seed);
            for (int i = 0; i < Lasers; i++)
            {
                var shooter = new ShooterSettings { DistanceM = 2 + random.NextDouble() };
                shooter.Laser.Color = i % 2 == 0 ? LaserColor.Green : LaserColor.Red;
                shooter.Laser.PowerMw = Logarithmic(random, 0.01, 5);
                shooter.Laser.DotRadiusMm = 3 + 4 * random.NextDouble();
                scenario.Shooters.Add(shooter);
            }

            for (double time = 1; time < scenario.DurationS - 1; time += secondsBetween * (0.7 + 0.6 * random.NextDouble()))
            {
                scenario.Shots.Add(new ShotSettings
                {
                    TimeS = time,
                    Shooter = 1 + random.Next(Lasers),
                    PulseMs = Logarithmic(random, 5, 300),
                    ScreenM = new Vector2D(0.05 + (screenM.X - 0.1) * random.NextDouble(), 0.05 + (screenM.Y - 0.1) * random.NextDouble()),
                });
            }
        }

        private static double Logarithmic(Random random, double low, double high) => low * Math.Pow(high / low, random.NextDouble());
    }
}
