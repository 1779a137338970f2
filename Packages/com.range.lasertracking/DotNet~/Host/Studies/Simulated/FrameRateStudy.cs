using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>The same still picture and shots seen by cameras of other rates, sizes and formats, and by ones that lose frames.</summary>
    internal sealed class FrameRateStudy : IStudy
    {
        private const double SecondsBetweenShots = 1;

        public string Name => "frame-rates";

        public string What => "7 to 120 frames/s, irregular frames, 640×480 to 1920×1080, three formats: share found, shots counted twice";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable(FormattableString.Invariant($"seeds {options.FirstSeed}…{options.LastSeed}; {ContrastLimit.Words}; light between two exposures, which no frame shows, is not counted"),
                ["camera", "seconds", .. ContrastLimit.Columns, "doubles", "false"]);
            var all = new List<TracedShot>();
            int allDoubles = 0, allFalse = 0;
            double allSeconds = 0;
            foreach (Camera camera in Cameras().Where(c => options.Includes(c.Name)))
            {
                var shots = new List<TracedShot>();
                int doubles = 0, falseCount = 0;
                double seconds = 0;
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(FormattableString.Invariant($"{camera.Name}, seed {seed}"));
                    var run = new SimulatedRun(camera.Create(seed));
                    run.Process(interrupted);
                    if (interrupted.IsCancellationRequested)
                        break;
                    shots.AddRange(run.Shots);
                    doubles += run.Doubles.Count;
                    falseCount += run.False.Count;
                    seconds += run.Seconds;
                }

                table.Add([camera.Name, seconds, .. ContrastLimit.Shares(shots), doubles, falseCount]);
                all.AddRange(shots);
                (allDoubles, allFalse, allSeconds) = (allDoubles + doubles, allFalse + falseCount, allSeconds + seconds);
            }

            table.Add(["all", allSeconds, .. ContrastLimit.Shares(all), allDoubles, allFalse]);
            return table;
        }

        /// <summary>Rates at one size; sizes and formats at one rate. Large pictures play for a shorter time.</summary>
        private static IEnumerable<Camera> Cameras()
        {
            foreach (double rate in new[] { 7, 15, 24, 30, 60, 120.0 })
                yield return new Camera(FormattableString.Invariant($"640×480, {rate} frames/s"), 640, 480, rate, 0, PixelFormat.Bgra32, 60);
            yield return new Camera("640×480, irregular, 8–60 frames/s", 640, 480, 60, 0.6, PixelFormat.Nv12, 60);
            yield return new Camera("640×480, 30 frames/s, 1 of 10 lost", 640, 480, 30, 0.1, PixelFormat.Yuy2, 60);
            foreach (PixelFormat format in new[] { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2 })
            {
                yield return new Camera(FormattableString.Invariant($"640×480, 30 frames/s, {format}"), 640, 480, 30, 0, format, 60);
                yield return new Camera(FormattableString.Invariant($"1280×720, 30 frames/s, {format}"), 1280, 720, 30, 0, format, 30);
                yield return new Camera(FormattableString.Invariant($"1920×1080, 30 frames/s, {format}"), 1920, 1080, 30, 0, format, 20);
            }
        }

        private sealed record Camera(string Name, int Width, int Height, double FramesPerSecond, double DroppedShare, PixelFormat Format, double DurationS)
        {
            public SimulatedRange Create(int seed)
            {
                var scenario = new SimulationScenario { Name = Name, Seed = seed, DurationS = DurationS };
                (scenario.ColorCamera.Width, scenario.ColorCamera.Height) = (Width, Height);
                (scenario.Projector.Width, scenario.Projector.Height) = (Math.Min(Width, 1280), Math.Min(Width, 1280) * 9 / 16);
                (scenario.ColorCamera.FramesPerSecond, scenario.ColorCamera.DroppedShare, scenario.ColorCamera.Format) = (FramesPerSecond, DroppedShare, Format);

                // Faster cameras gather less light and amplify it.
                scenario.ColorCamera.ExposureUs = Math.Min(16670, 0.9e6 / FramesPerSecond);
                scenario.ColorCamera.Gain = 16670 / scenario.ColorCamera.ExposureUs;
                scenario.DepthCamera.Enabled = false;
                LaserTracking.Scoring.SceneModel scene = StillCase.Still(SimulationScenes.Default());
                StillCase.AddShots(scenario, scene.ScreenSizeM, seed, SecondsBetweenShots);
                return new SimulatedRange(scenario, scene);
            }
        }
    }
}
