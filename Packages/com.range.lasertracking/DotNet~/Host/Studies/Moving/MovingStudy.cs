using System;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Pipeline;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Moving
{
    /// <summary>Shots and resting dots while the whole projected picture moves, with its rendered frames known and unknown.</summary>
    internal sealed class MovingStudy : IStudy
    {
        /// <summary>Linear rise of the brightest pixel, 1 = saturation, from which a flash counts: a tenth of it is 90 of 255 levels on black.</summary>
        private const double MinPeak = 0.1;

        public string Name => "moving";

        public string What => "shots and resting dots while the whole picture moves, rendered frames known and unknown";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("640×360 at 30 frames/s; six shapes of 90 to 170 px, 20 px a frame; delay 15 to 80 ms",
                "content", "session", "rendered", "shots", "false", "per 10 min", "dots a frame", "relied on", "delay error ms");
            foreach (ProjectedContent content in new[] { ProjectedContent.Shapes, ProjectedContent.ShapesOverTexture })
            {
                foreach (bool isResting in new[] { false, true })
                {
                    string name = content.ToString().ToLowerInvariant() + (isResting ? "-resting" : "-shots");
                    if ((options.Includes(name + "-known") || options.Includes(name + "-unknown")) && !interrupted.IsCancellationRequested)
                        RunCase(name, content, isResting, options, table, interrupted);
                }
            }

            table.Notes.Add(FormattableString.Invariant($"Shots: those whose light raises a pixel by {MinPeak} of saturation in some frame. 'relied on': share of the frames in which the expected view was. Nothing is fired in the first {MovingScenario.QuietS} s."));
            table.Notes.Add("Dots a frame: three lasers held for 60 s each, seen in the frame and within 4 px; in sessions of shots, the frames between the first and the last of a flash.");
            return table;
        }

        private static void RunCase(string name, ProjectedContent content, bool isResting, StudyOptions options, StudyTable table, CancellationToken interrupted)
        {
            var tallies = new[] { new Tally(), new Tally() };
            for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
            {
                SimulatedRange range = isResting ? MovingScenario.RestingDots(seed, content) : MovingScenario.Shots(seed, content);
                var history = new RenderedFrameHistory();
                MovingRun?[] runs =
                {
                    options.Includes(name + "-known") ? new MovingRun(range, new ExpectedView(history, range.Calibration)) : null,
                    options.Includes(name + "-unknown") ? new MovingRun(range, null) : null,
                };
                double delayUs = range.Scenario.Projector.DelayMs * 1000;
                using IFrameSource camera = range.CreateColorSource(), pictures = range.CreatePictureSource();
                using var feed = new RenderedFeed(pictures, history, 0, 0);
                using var frame = new Frame();
                while (!interrupted.IsCancellationRequested && camera.TryRead(frame))
                {
                    options.Progress.Show(FormattableString.Invariant($"{name}, seed {seed}, frame {frame.Index}"));
                    feed.AdvanceTo(frame.TimeUs);
                    foreach (MovingRun? run in runs)
                        run?.Process(frame, delayUs);
                }

                for (int i = 0; i < runs.Length; i++)
                {
                    if (runs[i] is { } run)
                        tallies[i].Add(run, range.Scenario);
                }
            }

            for (int i = 0; i < tallies.Length; i++)
            {
                if (tallies[i].HasRuns)
                    tallies[i].Write(content, isResting, i == 0, table);
            }
        }

        /// <summary>Sums over seeds.</summary>
        private sealed class Tally
        {
            private int _found, _all, _wrong, _dotsSeen, _dotsShown, _frames, _trusted;
            private double _minutes, _delayErrorUs;

            public bool HasRuns => _frames > 0;

            public void Add(MovingRun run, SimulationScenario scenario)
            {
                run.Score(scenario.ColorCamera.Width, MinPeak, out int found, out int all, out int wrong);
                _found += found;
                _all += all;
                _wrong += wrong;
                _dotsSeen += run.DotsSeen;
                _dotsShown += run.DotsShown;
                _frames += run.Frames;
                _trusted += run.TrustedFrames;
                _minutes += scenario.DurationS / 60;
                _delayErrorUs = Math.Max(_delayErrorUs, run.WorstDelayErrorUs);
            }

            public void Write(ProjectedContent content, bool isResting, bool isKnown, StudyTable table) => table.Add(
                content == ProjectedContent.Shapes ? "shapes" : "shapes over texture", isResting ? "resting dots" : "shots", isKnown ? "known" : "unknown",
                new Proportion(_found, _all), _wrong, _minutes > 0 ? 10 * _wrong / _minutes : 0, new Proportion(_dotsSeen, _dotsShown),
                isKnown && _frames > 0 ? _trusted / (double)_frames : 0, _delayErrorUs / 1000);
        }
    }
}
