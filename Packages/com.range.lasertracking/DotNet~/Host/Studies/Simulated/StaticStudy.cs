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

        private const int MaxNamed = 40;
        private const int MaxDrawn = 4;
        private static readonly double[] Bins = { 0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 1.01 };

        public string Name => "static";

        public string What => "simulated still pictures, shots of all contrasts and lengths; false shots per hour (five seeds: three hours)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            StillCase[] all = StillCase.All();
            StillCase[] cases = all.Where(c => options.Includes(c.Name)).ToArray();
            var table = new StudyTable(FormattableString.Invariant($"640×360, 30 frames/s, seeds {options.FirstSeed}…{options.LastSeed}; {ContrastLimit.Words}"),
                ["picture", "minutes", .. ContrastLimit.Columns, "doubles", "false", "false per hour"]);
            var tallies = cases.Select(_ => new Tally()).ToArray();

            // Seed by seed, so that an interrupted run has seen all pictures alike.
            for (int seed = options.FirstSeed; seed <= options.LastSeed; seed++)
            {
                for (int i = 0; i < cases.Length && !interrupted.IsCancellationRequested; i++)
                {
                    options.Progress.Show(FormattableString.Invariant($"seed {seed}, {cases[i].Name}"));
                    var run = new SimulatedRun(cases[i].Create(seed, SecondsPerSeed / all.Length));
                    run.Process(interrupted);

                    // What an interrupted run has not come to is not missed.
                    if (interrupted.IsCancellationRequested)
                        break;
                    tallies[i].Add(run);
                    NameThem(table, cases[i], seed, run, interrupted);
                }
            }

            var total = new Tally();
            for (int i = 0; i < cases.Length; i++)
            {
                tallies[i].Write(cases[i].Name, table);
                total.Add(tallies[i]);
            }

            total.Write("all", table);
            List<TracedShot> everything = total.Shots;
            table.Notes.Insert(0, "found by rise (share of the room left): " + string.Join(" · ", Bins.SkipLast(1).Select((low, i) =>
                FormattableString.Invariant($"{low:0.##}–{Math.Min(1, Bins[i + 1]):0.##}: {ContrastLimit.Share(everything.Where(s => s.Rise >= low && s.Rise < Bins[i + 1]))}"))));
            return table;
        }

        /// <summary>Each false shot, each double and each missed one above the limit, as far as there is room.</summary>
        private static void NameThem(StudyTable table, StillCase still, int seed, SimulatedRun run, CancellationToken interrupted)
        {
            string Draw(TracedShot s)
            {
                if (table.Notes.Count >= MaxDrawn)
                    return string.Empty;
                string name = FormattableString.Invariant($"static-{still.Name.Replace(' ', '-').Replace(",", string.Empty)}-{seed}-{s.BestFrame}.png");
                return ": " + MissPicture.Draw(run.Range, s, name, interrupted);
            }

            IEnumerable<string> lines = run.Shots.OrderByDescending(s => s.RiseOfAll).Where(s => !s.IsFound && s.Rise >= ContrastLimit.Rise).Select(s =>
                FormattableString.Invariant($"missed: {still.Name}, seed {seed}, frames {s.Truth.FirstVisibleFrame}…{s.Truth.LastVisibleFrame} at {s.Truth.PlacesPx[0].X:F0},{s.Truth.PlacesPx[0].Y:F0}, rise {s.Rise:F2} ({s.RiseLevels:F0} levels), weakest channel {s.RiseOfAll:F2}, {s.PulseMs:F0} ms") + Draw(s));
            string Name(string what, ReportedShot shot) => FormattableString.Invariant($"{what}: {still.Name}, seed {seed}, frame {shot.Frame} at {shot.PositionPx.X:F0},{shot.PositionPx.Y:F0}");
            foreach (string line in run.False.Select(f => Name("false", f)).Concat(run.Doubles.Select(d => Name("double", d))).Concat(lines))
            {
                if (table.Notes.Count < MaxNamed)
                    table.Notes.Add(line);
            }
        }

        private sealed class Tally
        {
            private double _seconds;
            private int _doubles;
            private int _false;

            public List<TracedShot> Shots { get; } = new();

            public void Add(SimulatedRun run)
            {
                Shots.AddRange(run.Shots);
                (_seconds, _doubles, _false) = (_seconds + run.Seconds, _doubles + run.Doubles.Count, _false + run.False.Count);
            }

            public void Add(Tally other)
            {
                Shots.AddRange(other.Shots);
                (_seconds, _doubles, _false) = (_seconds + other._seconds, _doubles + other._doubles, _false + other._false);
            }

            public void Write(string name, StudyTable table) =>
                table.Add([name, _seconds / 60, .. ContrastLimit.Shares(Shots), _doubles, _false, _seconds > 0 ? _false * 3600 / _seconds : 0]);
        }
    }
}
