using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Tracks;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Tracks
{
    /// <summary>Drawn dots through both trackers: who keeps the numbers, through crossings and gaps.</summary>
    internal sealed class DotTracksStudy : IStudy
    {
        private const int Frames = 900;
        private const int KeptFrames = 50;
        private const double InflatedPx = 64;
        private const int RememberedFrames = 30;
        private static readonly int[] Dots = { 1, 2, 4, 6, 8 };

        public string Name => "dot-tracks";

        public string What => "1 to 8 drawn dots that cross and hide: MOTA, IDF1, numbers kept over 50 frames and through gaps, dot tracker and SORT";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable(FormattableString.Invariant($"seeds {options.FirstSeed}…{options.LastSeed}, {Frames} frames each, 6 % missed, stray light in 12 % of the frames"),
                ["tracker", "dots", "MOTA %", "IDF1 %", "switches", $"kept over {KeptFrames} frames", .. DrawnDots.HiddenFrames.Select(n => n + " hidden"), "after all gaps"]);
            foreach ((string tracker, int dots) in from tracker in new[] { "dots", "sort, 64 px boxes" } from dots in Dots select (tracker, dots))
            {
                if (!options.Includes(tracker))
                    continue;
                Add(table, tracker, dots, options, interrupted);
            }

            table.Notes.Add("kept: of the dots that have a number before and after, over all frames and gaps; MOTA and IDF1: means over the seeds; 95 % intervals (Wilson) as if frames were independent");
            return table;
        }

        private static void Add(StudyTable table, string tracker, int dots, StudyOptions options, CancellationToken interrupted)
        {
            var metrics = new List<TrackMetrics>();
            var kept = new Proportion[DrawnDots.HiddenFrames.Length + 2];
            for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
            {
                options.Progress.Show(FormattableString.Invariant($"{tracker}, {dots} dots, seed {seed}"));
                var drawn = new DrawnDots(seed * 100 + dots, dots, Frames);
                List<MotRow> tracks = Track(tracker == "dots", drawn.Detections, interrupted);
                metrics.Add(TrackEvaluator.Evaluate(drawn.Truth, tracks, TrackMatch.Centre20, Frames));
                var keeping = new IdentityKeeping(drawn.Truth, tracks);
                Count(ref kept[0], keeping.KeptOver(KeptFrames));
                for (int i = 0; i < DrawnDots.HiddenFrames.Length; i++)
                    Count(ref kept[i + 1], keeping.KeptThroughGaps(DrawnDots.HiddenFrames[i], DrawnDots.HiddenFrames[i]));
                Count(ref kept[^1], keeping.KeptThroughGaps(1, int.MaxValue));
            }

            if (metrics.Count > 0)
                table.Add([tracker, dots, 100 * metrics.Average(m => m.Mota), 100 * metrics.Average(m => m.IdentityF1), metrics.Sum(m => m.Switches), .. kept.Cast<object>()]);
        }

        private static void Count(ref Proportion all, Proportion more) => all = new Proportion(all.Count + more.Count, all.Of + more.Of);

        private static List<MotRow> Track(bool isDots, List<MotRow> detections, CancellationToken interrupted)
        {
            var tracks = new List<MotRow>();
            if (isDots)
            {
                BoxTracking.Dots(detections, new DotTrackerSettings(), 30, 1920, tracks.Add, (_, _, _) => { }, interrupted);
                return tracks;
            }

            List<MotRow> inflated = detections.ConvertAll(row => row with
            {
                Box = new BoundingBox(row.Box.CenterX - InflatedPx / 2, row.Box.CenterY - InflatedPx / 2, InflatedPx, InflatedPx),
            });
            BoxTracking.Sort(inflated, new SortTrackerSettings { MaxAge = RememberedFrames }, tracks.Add, (_, _, _) => { }, interrupted);
            return tracks;
        }
    }
}
