using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>One situation: how many fire, how they stand, what goes wrong.</summary>
    /// <param name="Name">As on the command line.</param>
    /// <param name="Shooters">How many fire.</param>
    /// <param name="HasTrueDots">The dots come from the truth, not from camera 0's pictures: only hands and fusion can fail.</param>
    /// <param name="Change">What is special; gets the seed's random numbers.</param>
    internal sealed record MultiuserCase(string Name, int Shooters, bool HasTrueDots, Action<SimulationScenario, Random> Change)
    {
        private const double DurationS = 30;
        private const double ShotsPerMinute = 40;

        public static IReadOnlyList<MultiuserCase> All { get; } = Create().ToArray();

        /// <summary>All lasers are of one colour: nothing but geometry and memory can tell who fired.</summary>
        public SimulationScenario Scenario(int seed)
        {
            var random = new Random(1000 * seed + Shooters);
            var scenario = new SimulationScenario { Name = Name, Seed = seed, DurationS = DurationS };
            scenario.ColorCamera.Width = 960;
            scenario.ColorCamera.Height = 540;
            scenario.Generator.ShotsPerMinute = ShotsPerMinute;

            // Side by side, as far back as the field of view of camera 1 asks for.
            double spacing = Shooters <= 3 ? 0.7 : Shooters == 4 ? 0.6 : 0.42, distance = Shooters <= 3 ? 2.4 : 2.65;
            for (int i = 0; i < Shooters; i++)
                scenario.Shooters.Add(Person(random, (i - (Shooters - 1) / 2.0) * spacing + 0.06 * (random.NextDouble() - 0.5), distance + 0.2 * (random.NextDouble() - 0.5)));
            Change(scenario, random);
            return scenario;
        }

        private static IEnumerable<MultiuserCase> Create()
        {
            foreach (int shooters in new[] { 1, 2, 3, 4, 6 })
                yield return new MultiuserCase(shooters == 1 ? "1 shooter" : shooters + " shooters", shooters, true, (_, _) => { });
            foreach (int shooters in new[] { 1, 2, 4 })
                yield return new MultiuserCase(shooters + ", whole pipeline", shooters, false, (_, _) => { });
            foreach (int shooters in new[] { 2, 4 })
            {
                yield return new MultiuserCase(shooters + ", at the same time", shooters, true, (s, _) => s.Generator.SimultaneousShare = 1);
                yield return new MultiuserCase(shooters + ", crossing beams", shooters, true, Cross);
                yield return new MultiuserCase(shooters + ", somebody in front", shooters, true, StandInFront);
                yield return new MultiuserCase(shooters + ", hands hidden", shooters, true, (s, _) => s.DepthCamera.LostPalmShare = 0.4);
                yield return new MultiuserCase(shooters + ", depth frames lost", shooters, true, (s, _) => s.DepthCamera.DroppedShare = 0.4);
                yield return new MultiuserCase(shooters + ", depth at 15 Hz", shooters, true, (s, _) => s.DepthCamera.FramesPerSecond = 15);
                yield return new MultiuserCase(shooters + ", depth 70 ms late", shooters, true, (s, _) => s.DepthCamera.ClockOffsetUs = 70_000);
                yield return new MultiuserCase(shooters + ", clock drift, 10 min at 100 ppm", shooters, true, (s, _) =>
                {
                    s.DepthCamera.ClockOffsetUs = 60_000;
                    s.DepthCamera.ClockDriftPpm = 100;
                });
            }
        }

        private static ShooterSettings Person(Random random, double offsetXM, double distanceM) => new()
        {
            OffsetXM = offsetXM,
            DistanceM = distanceM,
            HeightM = 1.62 + 0.28 * random.NextDouble(),
            Hand = random.NextDouble() < 0.25 ? HandSide.Left : HandSide.Right,
            TwoHanded = random.NextDouble() < 0.5,
        };

        /// <summary>Everybody fires at the part of the screen that lies opposite: all lines cross.</summary>
        private static void Cross(SimulationScenario scenario, Random random)
        {
            scenario.Generator.ShotsPerMinute = 0;
            for (int shooter = 0; shooter < scenario.Shooters.Count; shooter++)
            {
                double side = -1.4 * scenario.Shooters[shooter].OffsetXM;
                Fire(scenario, random, shooter, side, 0.25);
            }
        }

        /// <summary>One who does not fire stands a metre before the first, half hiding them, weapon lowered.</summary>
        private static void StandInFront(SimulationScenario scenario, Random random)
        {
            scenario.Generator.ShotsPerMinute = 0;
            for (int shooter = 0; shooter < scenario.Shooters.Count; shooter++)
                Fire(scenario, random, shooter, 0, 1.5);
            ShooterSettings first = scenario.Shooters[0];
            scenario.Shooters.Add(Person(random, first.OffsetXM + 0.3, first.DistanceM - 0.9));
        }

        private static void Fire(SimulationScenario scenario, Random random, int shooter, double sideM, double spreadM)
        {
            Vector2D size = SimulationScenes.Default().ScreenSizeM;
            for (double time = 0.8 + random.NextDouble(); time < DurationS - 0.5; time += 0.7 + 1.6 * random.NextDouble())
            {
                scenario.Shots.Add(new ShotSettings
                {
                    TimeS = time,
                    Shooter = shooter + 1,
                    PulseMs = 20 + 80 * random.NextDouble(),
                    ScreenM = new Vector2D(Math.Clamp(size.X / 2 + sideM + spreadM * (2 * random.NextDouble() - 1), 0.1, size.X - 0.1), size.Y * (0.15 + 0.7 * random.NextDouble())),
                });
            }
        }
    }
}
