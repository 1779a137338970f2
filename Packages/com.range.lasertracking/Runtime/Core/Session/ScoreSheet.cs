using System.Collections.Generic;

namespace LaserTracking.Session
{
    /// <summary>Keeps score while a session runs: all shots together, each shooter's, the last one. One thread.</summary>
    public sealed class ScoreSheet
    {
        private readonly List<ReportTotals> _shooters = new List<ReportTotals>();
        private readonly List<ShotEvent> _lastOfShooter = new List<ShotEvent>();

        public ReportTotals Total { get; private set; } = new ReportTotals("all", 0);

        /// <summary>Who has fired, by number; those nobody knows of last, as shooter 0.</summary>
        public IReadOnlyList<ReportTotals> Shooters => _shooters;

        /// <summary>Meaningless before the first shot.</summary>
        public ShotEvent Last { get; private set; }

        /// <summary>Seconds since the same shooter's shot before; NaN for the first.</summary>
        public double LastIntervalS { get; private set; } = double.NaN;

        /// <summary>Adds a shot.</summary>
        public void Add(in ShotEvent shot)
        {
            int at = RowOf(shot.Shooter);
            ReportTotals row = _shooters[at];
            var entry = new ReportShot(shot) { TimeS = shot.Shot.TimeUs * 1e-6 };
            if (row.Shots > 0)
            {
                ShotEvent before = _lastOfShooter[at];
                entry.IntervalS = System.Math.Max(0, shot.Shot.TimeUs - before.Shot.TimeUs) * 1e-6;
                entry.IsTransition = before.HasHit && shot.HasHit && before.Hit.Target != shot.Hit.Target;
            }

            row.Add(entry);
            Total.Add(entry);
            _lastOfShooter[at] = shot;
            Last = shot;
            LastIntervalS = entry.IntervalS;
        }

        /// <summary>Begins anew.</summary>
        public void Clear()
        {
            Total = new ReportTotals("all", 0);
            _shooters.Clear();
            _lastOfShooter.Clear();
            LastIntervalS = double.NaN;
        }

        private int RowOf(int shooter)
        {
            int at = 0;
            while (at < _shooters.Count && _shooters[at].Number != 0 && (shooter == 0 || _shooters[at].Number < shooter))
                at++;
            if (at < _shooters.Count && _shooters[at].Number == shooter)
                return at;
            _shooters.Insert(at, new ReportTotals(shooter == 0 ? "unknown" : "shooter " + shooter, shooter));
            _lastOfShooter.Insert(at, default);
            return at;
        }
    }
}
