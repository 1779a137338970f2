using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies
{
    /// <summary>
    /// The advisor against what happens: it looks at the first two seconds of simulated rooms, in which nobody fires, and says what share
    /// of flashes of some powers and lengths will be caught; then they are fired, all over the screen, at any moment.
    /// </summary>
    internal sealed class AdvisorStudy : IStudy
    {
        private const double QuietS = 2;
        private const double IntervalS = 0.26;
        private const int ShotsPerKind = 24;
        private const int FramesBetweenLooks = 3;

        private static readonly double[] PulsesMs = { 7, 40 };
        private static readonly Room[] Rooms =
        {
            new("dim room, 16.7 ms", new[] { 0.015, 0.05, 0.4 }, _ => { }),
            new("lit room, 16.7 ms, white near clipping", new[] { 0.05, 0.15, 1.0 }, s => { s.ColorCamera.Gain = 1.7; s.Room.Ambient = 0.15; }),
            new("dim room, 4 ms", new[] { 0.04, 0.12, 1.0 }, s => s.ColorCamera.ExposureUs = 4000),
            new("noisy camera, 6 ms, gain 3", new[] { 0.04, 0.12, 1.0 }, s => { s.ColorCamera.ExposureUs = 6000; s.ColorCamera.Gain = 3; s.ColorCamera.FullWellElectrons = 2500; s.ColorCamera.ReadNoiseElectrons = 9; }),
            new("720p60 NV12, 8.3 ms", new[] { 0.02, 0.06, 0.4 }, s => { s.ColorCamera.Width = 1280; s.ColorCamera.Height = 720; s.ColorCamera.FramesPerSecond = 60; s.ColorCamera.ExposureUs = 8333; s.ColorCamera.Format = PixelFormat.Nv12; }),
            new("over-exposed, red laser", new[] { 0.3, 1.0, 3.0 }, s => { s.ColorCamera.Gain = 2.5; s.Room.Ambient = 0.25; }, LaserColor.Red),
        };

        public string Name => "advisor";

        public string What => "the predicted against the measured share of flashes caught, by room, power and length";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("The advisor's prediction against simulated flashes", "room", "laser", "mW", "pulse ms", "predicted %", "caught", "off, points");
            var offs = new List<double>();
            foreach (Room room in Rooms.Where(r => options.Includes(r.Name)))
            {
                var kinds = new Kind[room.PowersMw.Length * PulsesMs.Length];
                for (int i = 0; i < kinds.Length; i++)
                    kinds[i] = new Kind(room.PowersMw[i / PulsesMs.Length], PulsesMs[i % PulsesMs.Length]);
                int seeds = options.LastSeed - options.FirstSeed + 1;
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(FormattableString.Invariant($"{room.Name}, seed {seed}"));
                    Run(room, seed, kinds, interrupted);
                }

                foreach (Kind kind in kinds)
                {
                    var caught = new Proportion(kind.Caught, kind.Fired);
                    double off = 100 * (kind.Predicted / seeds - caught.Share);
                    offs.Add(off);
                    table.Add(room.Name, room.Color.ToString().ToLowerInvariant(), kind.PowerMw, kind.PulseMs, 100 * kind.Predicted / seeds, caught, off);
                }
            }

            if (offs.Count > 0)
            {
                table.Notes.Add(FormattableString.Invariant($"off by {offs.Average(Math.Abs):F1} points in the mean, {offs.Max(Math.Abs):F1} at most; within 10 points in {offs.Count(o => Math.Abs(o) <= 10)} of {offs.Count} cases, all cases together off by {offs.Average():F1}"));
                table.Notes.Add("predicted from two seconds without a shot; caught: of all flashes fired, those between two exposures included; 95 % intervals (Wilson)");
            }

            return table;
        }

        private static void Run(Room room, int seed, Kind[] kinds, CancellationToken interrupted)
        {
            SimulationScenario scenario = Scenario(room, seed, kinds, out int[] kindOfShot);
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            var detector = new ShotDetector();
            var tracker = new ShotTracker();
            var detections = new Detections();
            ColorCameraSettings camera = scenario.ColorCamera;
            var advisor = new DetectionAdvisor(detector, new AdvisorSettings
            {
                ExposureUs = camera.ExposureUs,
                Color = room.Color,
                WhiteLight = 0.55 * camera.Gain * camera.ExposureUs / 16670,
            }, range.Calibration.Screen);
            bool isAdvised = false;
            var found = new bool[range.Truth.Shots.Count];
            using IFrameSource source = new PrefetchingFrameSource(range.CreateColorSource());
            using var frame = new Frame();
            while (!interrupted.IsCancellationRequested && source.TryRead(frame))
            {
                detections.Begin(frame.Index, frame.TimeUs);
                detector.Process(frame, detections);
                tracker.Process(detections);
                if (frame.TimeUs < (QuietS - 0.1) * 1e6)
                {
                    if (frame.Index % FramesBetweenLooks == FramesBetweenLooks - 1)
                        advisor.LookEverywhere(frame);
                    else
                        advisor.Note(frame);
                }
                else if (!isAdvised)
                {
                    isAdvised = true;
                    DetectionAdvice advice = advisor.Advise();
                    foreach (Kind kind in kinds)
                        kind.Predicted += advice.Probability(kind.PowerMw, kind.PulseMs);
                }

                foreach (Shot shot in tracker.Shots)
                    Note(range.Truth, shot, camera.Width, found);
            }

            for (int i = 0; i < found.Length; i++)
            {
                Kind kind = kinds[kindOfShot[i]];
                kind.Fired++;
                kind.Caught += found[i] ? 1 : 0;
            }
        }

        private static void Note(SimulationTruth truth, Shot shot, int width, bool[] found)
        {
            for (int i = 0; i < found.Length; i++)
            {
                TrueShot fired = truth.Shots[i];
                if (fired.FirstFrame >= 0 && shot.FirstFrameIndex >= fired.FirstFrame && shot.FirstFrameIndex <= fired.LastFrame
                    && (shot.Dot.PositionPx - fired.FirstLightPx).Length < 4 * width / 640.0)
                    found[i] = true;
            }
        }

        /// <summary>Every power is a laser of its own; its flashes are of all lengths, at random points and moments.</summary>
        private static SimulationScenario Scenario(Room room, int seed, Kind[] kinds, out int[] kindOfShot)
        {
            int shots = ShotsPerKind * kinds.Length;
            var scenario = new SimulationScenario { Name = room.Name, Seed = seed, DurationS = QuietS + (shots + 1) * IntervalS };
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.DepthCamera.Enabled = false;
            room.Change(scenario);
            foreach (double power in room.PowersMw)
            {
                var shooter = new ShooterSettings();
                shooter.Laser.PowerMw = power;
                shooter.Laser.Color = room.Color;
                shooter.Tremor.AmplitudeMrad = 0;
                shooter.Tremor.SwayMrad = 0;
                scenario.Shooters.Add(shooter);
            }

            var random = new Random(seed);
            kindOfShot = Enumerable.Range(0, shots).Select(i => i % kinds.Length).ToArray();
            random.Shuffle(kindOfShot);
            Vector2D size = SimulationScenes.Default().ScreenSizeM;

            // Moments within a frame and places on the screen are spread evenly over the flashes of a kind, from a random beginning: chance then
            // moves the measured shares less than the intervals say.
            double framesPerSecond = scenario.ColorCamera.FramesPerSecond, beginX = random.NextDouble(), beginY = random.NextDouble(), beginPhase = random.NextDouble();
            var fired = new int[kinds.Length];
            for (int i = 0; i < shots; i++)
            {
                int n = fired[kindOfShot[i]]++;
                double x = (beginX + n * 0.7548776662466927) % 1, y = (beginY + n * 0.5698402909980532) % 1, phase = (beginPhase + n * 0.6180339887498949) % 1;
                double frame = Math.Ceiling((QuietS + i * IntervalS) * framesPerSecond);
                scenario.Shots.Add(new ShotSettings
                {
                    TimeS = (frame + phase) / framesPerSecond,
                    Shooter = 1 + kindOfShot[i] / PulsesMs.Length,
                    PulseMs = kinds[kindOfShot[i]].PulseMs,
                    ScreenM = new Vector2D((0.02 + 0.96 * x) * size.X, (0.02 + 0.96 * y) * size.Y),
                });
            }

            return scenario;
        }

        private sealed record Room(string Name, double[] PowersMw, Action<SimulationScenario> Change, LaserColor Color = LaserColor.Green);

        private sealed class Kind(double powerMw, double pulseMs)
        {
            public double PowerMw { get; } = powerMw;

            public double PulseMs { get; } = pulseMs;

            /// <summary>Sum over the seeds.</summary>
            public double Predicted { get; set; }

            public int Fired { get; set; }

            public int Caught { get; set; }
        }
    }
}
