using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Moving
{
    /// <summary>Simulated ranges whose whole picture moves: 640×360 at 30 frames/s, a 60 Hz projector, delay and phase drawn with the seed.</summary>
    internal static class MovingScenario
    {
        /// <summary>Seconds at the beginning in which nothing is fired: delay and colours are learned.</summary>
        public const double QuietS = 3;

        public const double ShotsDurationS = 60;
        public const double RestS = 60;

        /// <summary>Three shooters fire 20 shots a minute each, anywhere on the screen.</summary>
        public static SimulatedRange Shots(int seed, ProjectedContent content)
        {
            SimulationScenario scenario = Create(seed, content, QuietS + ShotsDurationS);
            var places = new System.Random(seed);
            int count = (int)ShotsDurationS;
            for (int i = 0; i < count; i++)
            {
                // One shot a second, at any phase of the camera's; lengths even in their logarithm as from real trainers.
                scenario.Shots.Add(new ShotSettings
                {
                    TimeS = QuietS + i + 0.5 * places.NextDouble(),
                    Shooter = 1 + i % 3,
                    PulseMs = 5 * System.Math.Pow(60, places.NextDouble()),
                    ScreenM = Place(places),
                });
            }

            return new SimulatedRange(scenario, SimulationScenes.Empty());
        }

        /// <summary>Three lasers rest on their spots for a minute, held by people.</summary>
        public static SimulatedRange RestingDots(int seed, ProjectedContent content)
        {
            SimulationScenario scenario = Create(seed, content, QuietS + RestS + 1);
            var places = new System.Random(seed);
            for (int i = 0; i < 3; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = QuietS + 0.1 * i, Shooter = i + 1, PulseMs = RestS * 1000, ScreenM = new Vector2D(0.4 + 0.9 * i + 0.6 * places.NextDouble(), 0.2 + 1.4 * places.NextDouble()) });
            return new SimulatedRange(scenario, SimulationScenes.Empty());
        }

        private static Vector2D Place(System.Random places) => new(0.15 + 2.9 * places.NextDouble(), 0.15 + 1.5 * places.NextDouble());

        private static SimulationScenario Create(int seed, ProjectedContent content, double durationS)
        {
            var random = new System.Random(seed + 1000);
            var scenario = new SimulationScenario { Name = "moving", Seed = seed, DurationS = durationS };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Width = scenario.Projector.Width = 640;
            scenario.ColorCamera.Height = scenario.Projector.Height = 360;
            scenario.ColorCamera.StartUs = 16_667 + 33_333 * random.NextDouble();
            scenario.Projector.DelayMs = 15 + 65 * random.NextDouble();
            scenario.Projector.Content = content;
            for (int i = 0; i < 3; i++)
            {
                var shooter = new ShooterSettings { OffsetXM = i - 1 };
                shooter.Laser.Color = i == 1 ? LaserColor.Red : LaserColor.Green;
                scenario.Shooters.Add(shooter);
            }

            return scenario;
        }
    }
}
