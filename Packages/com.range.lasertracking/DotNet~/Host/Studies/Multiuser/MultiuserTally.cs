using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Host.Scoring;
using LaserTracking.Session;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>What all seeds of one situation gave.</summary>
    internal sealed class MultiuserTally
    {
        public static readonly string[] Columns =
        {
            "case", "right", "wrong", "unknown", "switches", "swaps", "side right", "MOTA %", "IDF1 %", "arm seen %", "muzzle mm", "p95", "palm mm", "p95 ", "stated %", "withheld %", "direction °", "pair ms",
        };

        /// <summary>Hands hold still longer than that.</summary>
        private const double WorthSayingMs = 8;

        private readonly List<NamedShot> _shots = new();
        private readonly List<SaidPalm> _palms = new();
        private readonly List<TrackMetrics> _tracks = new();
        private int _swaps;
        private readonly List<(double OffsetMs, double? SaidMs)> _clocks = new();

        public IReadOnlyList<NamedShot> Shots => _shots;

        public IReadOnlyList<SaidPalm> Palms => _palms;

        public void Add(MultiuserRun run)
        {
            _shots.AddRange(run.Shots);
            _palms.AddRange(run.Palms);
            _tracks.Add(run.Tracks);
            _swaps += run.Swaps;
            _clocks.Add((run.ClockOffsetMs, run.ClockSaidMs));
        }

        /// <summary>How many shots were unknown or wrong for which reason, most frequent first; empty where none was.</summary>
        public string Reasons() => string.Join("; ", _shots.Where(s => !s.IsRight).GroupBy(s => s.WhyNot).OrderByDescending(g => g.Count()).ThenBy(g => g.Key, StringComparer.Ordinal)
            .Select(g => FormattableString.Invariant($"{g.Key} {g.Count()} ({g.Count(s => s.IsNamed)} wrong)")));

        /// <summary>In how many sessions an offset of camera 1's clock was said, and how far off; empty where there is none and none was said.</summary>
        public string Clocks()
        {
            double[] errors = _clocks.Where(c => c.SaidMs != null).Select(c => Math.Abs(c.SaidMs!.Value - c.OffsetMs)).ToArray();
            if (errors.Length == 0)
                return _clocks.TrueForAll(c => Math.Abs(c.OffsetMs) < WorthSayingMs) ? "" : FormattableString.Invariant($"said in none of {_clocks.Count} sessions");
            return FormattableString.Invariant($"said in {errors.Length} of {_clocks.Count} sessions, off by {Quantile(errors, 0.5):F1} ms (median), {Quantile(errors, 1):F1} (most)");
        }

        public void Write(string name, StudyTable table)
        {
            double[] muzzles = _shots.Where(s => s.HasRightMuzzle && s.IsArmSeen).Select(s => s.MuzzleErrorMm).ToArray();
            double[] palms = _palms.Where(p => p.IsStated).Select(p => p.ErrorMm).ToArray();
            NamedShot[] sided = _shots.Where(s => s.IsSideSaid).ToArray(), paired = _shots.Where(s => s.HasRightMuzzle).ToArray();
            table.Add(name, Share(s => s.IsRight), Share(s => s.IsNamed && !s.IsRight), Share(s => !s.IsNamed), _shots.Count(s => s.IsSwitch), _swaps,
                new Proportion(sided.Count(s => s.Said.Hand == s.Fired.Hand), sided.Length),
                100 * _tracks.Average(t => t.Mota), 100 * _tracks.Average(t => t.IdentityF1),
                100.0 * _shots.Count(s => s.IsArmSeen) / Math.Max(1, _shots.Count),
                Quantile(muzzles, 0.5), Quantile(muzzles, 0.95), Quantile(palms, 0.5), Quantile(palms, 0.95), 100.0 * palms.Length / Math.Max(1, _palms.Count),
                100.0 * _palms.Count(p => p.IsFound && !p.IsStated) / Math.Max(1, _palms.Count),
                Quantile(paired.Select(s => s.DirectionErrorDeg).ToArray(), 0.5), Quantile(paired.Select(s => Math.Abs(s.Said.PairDeltaUs) / 1000.0).ToArray(), 0.5));
        }

        public static double Quantile(double[] values, double share)
        {
            if (values.Length == 0)
                return double.NaN;
            double[] sorted = values.Order().ToArray();
            return sorted[(int)Math.Min(sorted.Length - 1, Math.Floor(share * sorted.Length))];
        }

        private Proportion Share(Func<NamedShot, bool> which) => new(_shots.Count(which), _shots.Count);
    }
}
