using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Host.Studies.Clips;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>The watch for a moved camera: pictures that move without it, cameras that are knocked, pan and creep.</summary>
    internal sealed class DriftStudy : IStudy
    {
        private const int MaxNamed = 40;

        public string Name => "drift";

        public string What => "the watch for a moved camera: drawn pictures, simulated rooms, the recorded clips displaced; false alarms, knocks noticed, after how long";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            string[] names = [.. DrawnSessions.Rows, .. SimulatedSessions.Rows, .. ClipSessions.Rows];
            Dictionary<string, DriftTally> rows = names.Where(options.Includes).ToDictionary(name => name, _ => new DriftTally());
            var table = new StudyTable(FormattableString.Invariant($"640×360, 15 frames/s, seeds {options.FirstSeed}…{options.LastSeed}; knocks of 2 to 10 px, no screen known where the row does not say so"), DriftTally.Columns);
            for (int seed = options.FirstSeed; seed <= options.LastSeed; seed++)
            {
                foreach (string row in DrawnSessions.Rows.Where(rows.ContainsKey))
                    Play(row, seed, () => DrawnSessions.Create(row, seed));
                foreach (string kind in SimulatedSessions.Kinds.Where(kind => rows.Keys.Any(row => row.StartsWith(kind, StringComparison.Ordinal))))
                    Play(kind, seed, () => SimulatedSessions.Create(kind, seed));
            }

            if (ClipSessions.Rows.Any(rows.ContainsKey))
            {
                ClipSet? clips = ClipSet.TryOpen();
                if (clips == null)
                    table.Notes.Add("the recorded clips are not there: set RANGE_DATA to the folder that holds clips/truth.json");
                foreach (Scoring.TruthClip clip in clips?.Clips ?? [])
                {
                    foreach (Vector2D way in ClipSessions.Ways)
                        Play(clip.File, 0, () => ClipSessions.Create(clips!, clip, way));
                }
            }

            foreach ((string name, DriftTally tally) in rows.Where(row => row.Value.HasSessions))
                tally.Write(name, table);
            table.Notes.Add(FormattableString.Invariant($"In time: within {DriftTally.InTimeS} s after two pixels were reached. Right: within 0.5 px and a tenth of its length; a pan or creep, said in parts, within 1.5 px and a tenth."));
            string[] failures = rows.Values.SelectMany(tally => tally.Failures).ToArray();
            table.Notes.AddRange(failures.Take(MaxNamed));
            if (failures.Length > MaxNamed)
                table.Notes.Add(FormattableString.Invariant($"… and {failures.Length - MaxNamed} more"));
            return table;

            void Play(string what, int seed, Func<DriftSession> create)
            {
                if (interrupted.IsCancellationRequested)
                    return;
                options.Progress.Show(seed > 0 ? FormattableString.Invariant($"seed {seed}, {what}") : what);
                DriftTally.Play(create(), rows);
            }
        }
    }
}
