using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Sources;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>
    /// Reliability of the confidence: of all dots given so much, how many are lasers. Dots at their first sight, also those that the
    /// tracker never confirms; once with the detector as it is, once with limits so wide that much passes which is no laser.
    /// </summary>
    internal sealed class ConfidenceStudy : IStudy
    {
        private const int Bins = 10;
        private const double ReachPx = 5;

        public string Name => "confidence";

        public string What => "reliability table of the confidence on simulated ranges and, where RANGE_DATA has them, on recorded clips";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("First sight of dots, by the confidence they were given", "dots", "confidence", "lasers", "mean confidence");
            List<JudgedDot> simulated = new(), simulatedWide = new(), recorded = new(), recordedWide = new();
            foreach (string name in MeasuredRange.Names.Where(options.Includes))
            {
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(name + ", seed " + seed);
                    Simulate(MeasuredRange.Create(name, seed), simulated, simulatedWide, interrupted);
                }
            }

            foreach (TruthClip clip in Clips(out string folder).Where(c => options.Includes(c.File)))
            {
                options.Progress.Show(clip.File);
                Replay(Path.Combine(folder, clip.File), clip, recorded, recordedWide, interrupted);
            }

            AddRows(table, "simulated", simulated);
            AddRows(table, "simulated, wide limits", simulatedWide);
            AddRows(table, "clips", recorded);
            AddRows(table, "clips, wide limits", recordedWide);
            return table;
        }

        private static IReadOnlyList<TruthClip> Clips(out string folder)
        {
            string data = Environment.GetEnvironmentVariable("RANGE_DATA") ?? Path.Combine(RepositoryFolder.Find(), "..", "shared", "data");
            folder = Path.Combine(data, "clips");
            string truth = Path.Combine(folder, "truth.json");
            return File.Exists(truth) ? TruthFile.Read(truth) : Array.Empty<TruthClip>();
        }

        private static void Simulate(SimulationScenario scenario, List<JudgedDot> dots, List<JudgedDot> wide, CancellationToken interrupted)
        {
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            using IFrameSource source = range.CreateColorSource();
            double reach = ReachPx * scenario.ColorCamera.Width / 640;
            Judge(source, dots, wide, interrupted, (frame, at) =>
            {
                foreach (TrueDot dot in range.Truth.DotsOf(frame))
                {
                    if ((dot.PositionPx - at).Length <= reach + dot.StreakPx.Length / 2)
                        return true;
                }

                return false;
            });
        }

        private static void Replay(string path, TruthClip clip, List<JudgedDot> dots, List<JudgedDot> wide, CancellationToken interrupted)
        {
            double reach = ReachPx * clip.Width / 640;
            using IFrameSource source = FrameSources.OpenScreenCamera(path);
            Judge(source, dots, wide, interrupted, (frame, at) => clip.Shots.Any(s =>
                frame >= s.FirstVisibleFrame && frame <= s.LastVisibleFrame && s.PlacesPx.Any(p => (p - at).Length <= reach)));
        }

        private static void Judge(IFrameSource source, List<JudgedDot> dots, List<JudgedDot> wide, CancellationToken interrupted, Func<int, Geometry.Vector2D, bool> isLaser)
        {
            ShotDetector usual = new(), generous = new(WideLimits());
            var detections = new Detections();
            using var frame = new Frame();
            while (!interrupted.IsCancellationRequested && source.TryRead(frame))
            {
                Judge(usual, frame, detections, dots, isLaser);
                Judge(generous, frame, detections, wide, isLaser);
            }
        }

        private static void Judge(ShotDetector detector, Frame frame, Detections detections, List<JudgedDot> dots, Func<int, Geometry.Vector2D, bool> isLaser)
        {
            detections.Begin(frame.Index, frame.TimeUs);
            detector.Process(frame, detections);
            foreach (Dot dot in detections.Dots)
            {
                if (dot.IsOnset)
                    dots.Add(new JudgedDot(dot.Confidence, isLaser(frame.Index, dot.PositionPx)));
            }
        }

        /// <summary>Limits a few times as wide as the defaults: the judge lets through what it should not.</summary>
        private static ShotDetectorSettings WideLimits() => new()
        {
            MinRiseSigmas = 4,
            MinRise = 0.08,
            MinLogOdds = -3,
            MaxRingShare = 0.12,
        };

        private static void AddRows(StudyTable table, string name, List<JudgedDot> dots)
        {
            if (dots.Count == 0)
                return;
            double error = 0;
            for (int bin = 0; bin < Bins; bin++)
            {
                JudgedDot[] inside = dots.Where(d => Math.Min(Bins - 1, (int)(d.Confidence * Bins)) == bin).ToArray();
                if (inside.Length == 0)
                    continue;
                var lasers = new Proportion(inside.Count(d => d.IsLaser), inside.Length);
                double mean = inside.Average(d => d.Confidence);
                error += inside.Length * Math.Abs(lasers.Share - mean) / dots.Count;
                table.Add(name, FormattableString.Invariant($"{bin / (double)Bins:F1}–{(bin + 1) / (double)Bins:F1}"), lasers, mean);
            }

            table.Notes.Add(FormattableString.Invariant($"{name}: {dots.Count} dots, expected calibration error {error:F3}"));
        }
    }
}
