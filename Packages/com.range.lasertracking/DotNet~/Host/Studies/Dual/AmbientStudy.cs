using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Dual
{
    /// <summary>
    /// The dual filter's claims on the simulated range: lasers that rest on the wall from the first frame on, at 850 nm and at 532 nm,
    /// one to ten at once, while ambient light raises colour and infrared to 30…200.
    /// </summary>
    internal sealed class AmbientStudy : IStudy
    {
        private static readonly double[] Levels = { 30, 60, 100, 150, 200 };
        private static readonly int[] Counts = { 1, 3, 10 };

        public string Name => "ambient";

        public string What => "dual mode: lasers at rest in ambient light 30…200, 1 to 10 at once, 850 and 532 nm; found, false.";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable($"Dual mode in ambient light, seeds {options.FirstSeed}..{options.LastSeed}", "case", "lasers found", "right color", "error px", "false dots a frame", "false shots");
            foreach (bool hasTargets in new[] { false, true })
            {
                foreach (LaserColor color in new[] { LaserColor.Infrared, LaserColor.Green })
                {
                    foreach (double level in Levels)
                    {
                        foreach (int count in Counts)
                            AddCase(table, options, hasTargets, color, level, count, interrupted);
                    }
                }
            }

            table.Notes.Add("Colour 640×360, infrared 512×512 (passive), 45 frames, exact plane mapping. A laser is found when at least 95 % of the frames from the fifth on show a dot within 3 px of it.");
            table.Notes.Add("850 nm: about 130 counts over the wall in infrared, next to nothing in colour. 532 nm: 2 mW, nothing in infrared. \"Targets\": the default scene, half of it moving, at a third of full brightness.");
            return table;
        }

        private static void AddCase(StudyTable table, StudyOptions options, bool hasTargets, LaserColor color, double level, int count, CancellationToken interrupted)
        {
            string name = FormattableString.Invariant($"{(hasTargets ? "targets" : "wall")}, {(color == LaserColor.Green ? 532 : 850)} nm, ambient {level}, {count} {(count == 1 ? "dot" : "dots")}");
            if (!options.Includes(name))
                return;
            var tally = new AmbientTally();
            for (int seed = options.FirstSeed; seed <= options.LastSeed; seed++)
            {
                interrupted.ThrowIfCancellationRequested();
                options.Progress.Show(FormattableString.Invariant($"{name}, seed {seed} …"));
                Play(new SimulatedRange(Scenario(color, level, count, hasTargets, seed), hasTargets ? SimulationScenes.Default() : Wall()), color, tally);
            }

            table.Add(name, new Proportion(tally.Found, tally.Lasers), new Proportion(tally.RightColor, tally.Seen), tally.MeanErrorPx, tally.FalseDots / (double)tally.Frames, tally.FalseShots);
        }

        private static SceneModel Wall() => new("wall", new Pose(new Vector3D(0, 1.5, 0), Rotation3D.Identity), new Vector2D(3.2, 1.8), new Vector3D(0, 1.6, -2.4), 1, Array.Empty<SceneObject>());

        private static SimulationScenario Scenario(LaserColor color, double level, int count, bool hasTargets, int seed)
        {
            var scenario = new SimulationScenario { Name = "ambient", Seed = seed, DurationS = 1.5 };
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.Projector.Brightness = hasTargets ? 0.33 : 0.02;
            scenario.DepthCamera.Enabled = false;

            // The wall's value in the picture, undone: gamma 2.2, and white of brightness 1 lies at 55 % of saturation.
            scenario.Room.Ambient = Math.Pow(level / 255, scenario.ColorCamera.Gamma) / 0.55;
            scenario.InfraredCamera.Enabled = true;
            scenario.InfraredCamera.Width = scenario.InfraredCamera.Height = 512;
            scenario.InfraredCamera.AmbientCounts = level;
            var random = new Random(seed * 100 + count);
            var places = new List<Vector2D>();
            while (places.Count < count)
            {
                var place = new Vector2D(0.15 + 2.9 * random.NextDouble(), 0.15 + 1.5 * random.NextDouble());
                if (places.TrueForAll(other => (other - place).Length > 0.25))
                    places.Add(place);
            }

            for (int i = 0; i < count; i++)
            {
                scenario.Shooters.Add(new ShooterSettings { OffsetXM = (i - (count - 1) / 2.0) * 0.3 });
                scenario.Shooters[i].Laser.Color = color;
                if (color == LaserColor.Infrared)
                    scenario.Shooters[i].Laser.PowerMw = 0.1;
                scenario.Shots.Add(new ShotSettings { TimeS = 0, Shooter = i + 1, PulseMs = 1499, ScreenM = places[i] });
            }

            return scenario;
        }

        private static void Play(SimulatedRange range, LaserColor color, AmbientTally tally)
        {
            var detector = new DualShotDetector(null, range.InfraredMapping);
            detector.SetScreenPolygon(range.Calibration.Screen.CornersPx);
            var tracker = new ShotTracker();
            var detections = new Detections();
            tally.Begin(range.Scenario.Shots.Count);
            using IFrameSource source = range.CreateColorSource();
            using var frame = new Frame();
            while (source.TryRead(frame))
            {
                detector.Process(frame, detections);
                tracker.Process(detections);
                tally.Add(frame.Index, range.Truth.DotsOf(frame.Index), detections.Dots, tracker.Shots, color);
            }

            tally.End();
        }
    }
}
