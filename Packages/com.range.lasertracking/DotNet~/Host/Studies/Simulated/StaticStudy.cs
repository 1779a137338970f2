using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>Still pictures of different kinds and brightness: which shots are found, by how far they rise, and how often none is reported as one.</summary>
    internal sealed class StaticStudy : IStudy
    {
        /// <summary>36 minutes a seed: five seeds make three hours.</summary>
        private const double SecondsPerSeed = 36 * 60;

        private const int MaxNamed = 24;
        private const int MaxDrawn = 8;
        private static readonly double[] Bins = { 0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 1.01 };

        public string Name => "static";

        public string What => "simulated still pictures, shots of all contrasts and lengths; false shots per hour (five seeds: three hours)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            StillCase[] all = StillCase.All();
            StillCase[] cases = all.Where(c => options.Includes(c.Name)).ToArray();
            var table = new StudyTable(FormattableString.Invariant($"640×360, 30 frames/s, seeds {options.FirstSeed}…{options.LastSeed}; {ContrastLimit.Words}"),
                "picture", "minutes", "above the limit found", "below it found", "doubles", "false", "false per hour");
            var everything = new List<TracedShot>();
            int allFalse = 0, allDoubles = 0;
            double allSeconds = 0;
            foreach (StillCase still in cases)
            {
                var shots = new List<TracedShot>();
                int falseCount = 0, doubles = 0;
                double seconds = 0;
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(FormattableString.Invariant($"{still.Name}, seed {seed}"));
                    var run = new SimulatedRun(still.Create(seed, SecondsPerSeed / all.Length));
                    run.Process(interrupted);
                    shots.AddRange(run.Shots);
                    falseCount += run.False.Count;
                    doubles += run.Doubles.Count;
                    seconds += run.Seconds;
                    NameThem(table, still, seed, run, interrupted);
                }

                table.Add(still.Name, seconds / 60, ContrastLimit.ShareAbove(shots), ContrastLimit.ShareBelow(shots), doubles, falseCount, PerHour(falseCount, seconds));
                everything.AddRange(shots);
                (allFalse, allDoubles, allSeconds) = (allFalse + falseCount, allDoubles + doubles, allSeconds + seconds);
            }

            table.Add("all", allSeconds / 60, ContrastLimit.ShareAbove(everything), ContrastLimit.ShareBelow(everything), allDoubles, allFalse, PerHour(allFalse, allSeconds));
            table.Notes.Insert(0, "found by rise (share of the room left): " + string.Join(" · ", Bins.SkipLast(1).Select((low, i) =>
                FormattableString.Invariant($"{low:0.##}–{Math.Min(1, Bins[i + 1]):0.##}: {ContrastLimit.Share(everything.Where(s => s.Rise >= low && s.Rise < Bins[i + 1]))}"))));
            return table;
        }

        private static double PerHour(int count, double seconds) => seconds > 0 ? count * 3600 / seconds : 0;

        /// <summary>Each missed shot above the limit and each false one, as far as there is room.</summary>
        private static void NameThem(StudyTable table, StillCase still, int seed, SimulatedRun run, CancellationToken interrupted)
        {
            string Draw(TracedShot s)
            {
                if (table.Notes.Count >= MaxDrawn)
                    return string.Empty;
                string name = FormattableString.Invariant($"static-{still.Name.Replace(' ', '-').Replace(",", string.Empty)}-{seed}-{s.BestFrame}.png");
                return ": " + MissPicture.Draw(run.Range, s, name, interrupted);
            }

            IEnumerable<string> lines = run.Shots.Where(s => !s.IsFound && ContrastLimit.IsAbove(s)).Select(s =>
                FormattableString.Invariant($"missed: {still.Name}, seed {seed}, frames {s.Truth.FirstVisibleFrame}…{s.Truth.LastVisibleFrame} at {s.Truth.PlacesPx[0].X:F0},{s.Truth.PlacesPx[0].Y:F0}, rise {s.Rise:F2} ({s.RiseLevels:F0} levels), {s.PulseMs:F0} ms") + Draw(s));
            foreach (string line in lines.Concat(run.False.Select(f => FormattableString.Invariant($"false: {still.Name}, seed {seed}, frame {f.Frame} at {f.PositionPx.X:F0},{f.PositionPx.Y:F0}"))))
            {
                if (table.Notes.Count < MaxNamed)
                    table.Notes.Add(line);
            }
        }
    }
}
