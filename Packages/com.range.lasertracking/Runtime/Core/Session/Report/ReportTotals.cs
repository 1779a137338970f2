using System;

namespace LaserTracking.Session
{
    /// <summary>Sums over a set of shots: a shooter's, a target's or all.</summary>
    public sealed class ReportTotals
    {
        private double _splitSum;
        private double _transitionSum;

        internal ReportTotals(string name, int number)
        {
            Name = name;
            Number = number;
        }

        public string Name { get; }

        /// <summary>Of a shooter, 0: unknown; of a target, its object's index.</summary>
        public int Number { get; }

        /// <summary>All of them.</summary>
        public int Shots { get; private set; }

        /// <summary>Hits on targets that one should hit.</summary>
        public int Hits { get; private set; }

        /// <summary>Hits that count against the shooter.</summary>
        public int Mistakes { get; private set; }

        public int Misses => Shots - Hits - Mistakes;

        public long Points { get; private set; }

        /// <summary>Points weighed by the scoring rule.</summary>
        public double Score { get; private set; }

        public double FirstS { get; private set; } = double.NaN;

        public double LastS { get; private set; } = double.NaN;

        /// <summary>Pairs of shots on the same target, one after the other.</summary>
        public int Splits { get; private set; }

        /// <summary>Seconds; NaN without a split.</summary>
        public double BestSplitS { get; private set; } = double.NaN;

        public double MeanSplitS => Splits > 0 ? _splitSum / Splits : double.NaN;

        public int Transitions { get; private set; }

        public double MeanTransitionS => Transitions > 0 ? _transitionSum / Transitions : double.NaN;

        /// <summary>Adds a shot; shots come in order of time.</summary>
        internal void Add(ReportShot shot)
        {
            if (Shots++ == 0)
                FirstS = shot.TimeS;
            LastS = shot.TimeS;
            if (shot.Event.HasHit)
            {
                if (shot.IsMistake)
                    Mistakes++;
                else
                    Hits++;
                Points += shot.Event.Hit.Points;
                Score += shot.Event.Hit.Score;
            }

            if (double.IsNaN(shot.IntervalS))
                return;
            if (shot.IsTransition)
            {
                Transitions++;
                _transitionSum += shot.IntervalS;
            }
            else
            {
                Splits++;
                _splitSum += shot.IntervalS;
                BestSplitS = Splits == 1 ? shot.IntervalS : Math.Min(BestSplitS, shot.IntervalS);
            }
        }
    }
}
