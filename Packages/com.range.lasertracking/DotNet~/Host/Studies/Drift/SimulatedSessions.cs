using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>Simulated rooms of random light, camera and content, watched with and without knowing where the screen is.</summary>
    internal static class SimulatedSessions
    {
        private const string Rest = "simulated room at rest", Knock = "simulated room, knocked", Creep = "simulated room, creeping", Early = "simulated room, knocked in the first 2 s", Known = ", screen known";

        public static readonly string[] Kinds = { Rest, Knock, Creep, Early };

        public static readonly string[] Rows = { Rest, Rest + Known, Knock, Knock + Known, Creep, Creep + Known, Early, Early + Known };

        private const double CreepStepPx = 0.1;

        public static DriftSession Create(string kind, int seed)
        {
            var random = new Random(seed * 17 + Array.IndexOf(Kinds, kind));
            double Uniform(double low, double high) => low + (high - low) * random.NextDouble();
            var scenario = new SimulationScenario { Name = "drift", Seed = seed };
            ColorCameraSettings camera = scenario.ColorCamera;
            camera.Width = scenario.Projector.Width = 640;
            camera.Height = scenario.Projector.Height = 360;
            camera.FramesPerSecond = 15;
            camera.BlurPx = Uniform(0.4, 1.5);
            camera.FullWellElectrons = Uniform(2500, 15000);
            camera.FieldOfViewDeg = random.Next(2) == 0 ? 0 : Uniform(62, 80);
            scenario.DepthCamera.Enabled = false;
            scenario.Projector.RefreshHz = 30;
            scenario.Projector.Brightness = Uniform(0.4, 1.2);
            scenario.Projector.Content = (ProjectedContent)random.Next(3);
            scenario.Projector.ContentSpeed = Math.Exp(Uniform(Math.Log(0.02), Math.Log(1)));
            scenario.Room.Ambient = Math.Exp(Uniform(Math.Log(0.005), Math.Log(0.2)));

            double angle = Uniform(0, 2 * Math.PI), length = kind == Creep ? Uniform(2.5, 5) : Uniform(2, 10), from = double.PositiveInfinity, due = from;
            var way = new Vector2D(Math.Cos(angle), Math.Sin(angle));
            scenario.DurationS = 9;
            if (kind == Creep)
            {
                // In steps too small to see: so many pixels a second.
                double rate = Uniform(0.15, 0.6);
                int steps = (int)Math.Ceiling(length / CreepStepPx);
                length = steps * CreepStepPx;
                from = 2.5;
                due = from + 2 / rate;
                scenario.DurationS = from + length / rate + 6;
                for (int i = 0; i < steps; i++)
                    scenario.Nudges.Add(new NudgeSettings { TimeS = from + (i + 0.5) * CreepStepPx / rate, ShiftPx = way * CreepStepPx });
            }
            else if (kind != Rest)
            {
                from = due = kind == Early ? Uniform(0.05, 2) : Uniform(2.5, 4);
                scenario.Nudges.Add(new NudgeSettings { TimeS = from, ShiftPx = way * length });
            }

            var range = new SimulatedRange(scenario, SimulationScenes.Empty());
            string name = FormattableString.Invariant($"{kind}, seed {seed} ({scenario.Projector.Content}, ambient {scenario.Room.Ambient:F3})");
            return new DriftSession(name, Play(range), [(kind, null), (kind + Known, range.Calibration.Screen.OutlinePx)], from, due, kind == Rest ? default : way * length, kind == Creep);
        }

        private static IEnumerable<Frame> Play(SimulatedRange range)
        {
            using IFrameSource source = range.CreateColorSource();
            using var frame = new Frame();
            while (source.TryRead(frame))
                yield return frame;
        }
    }
}
