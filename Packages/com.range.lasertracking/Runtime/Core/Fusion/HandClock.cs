using System;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// How far camera 1's clock is off camera 0's: of all offsets those at which the lines of sight of those who may have fired met their dots
    /// (<see cref="SwingShot"/>), over the last shots together. Only dots that move are asked: a hand holds still before its shot and swings on after it,
    /// so the others favour the middle of that. Bounded, without allocation once built, deterministic.
    /// </summary>
    internal sealed class HandClock
    {
        private struct Waiting
        {
            public long TimeUs;
            public long TimeSigmaUs;
            public Vector3D DotM;
        }

        /// <summary>Offsets are looked for that far around <see cref="_centreUs"/>. What lies at the very end may lie beyond it.</summary>
        private const long ReachUs = 700_000;
        private const long EdgeUs = 50_000;

        /// <summary>Offsets beyond the first are that much less likely beforehand: no camera that is set up keeps its pictures so long.</summary>
        private const long UsualUs = 200_000;
        private static readonly double LogFarShare = Math.Log(0.001);

        /// <summary>Logarithm: what is less likely than the best by more is nothing beside it in a double's sixteen digits.</summary>
        private const double MaxDifference = 40;

        /// <summary>Beforehand the clock is that much likelier as known, to within <see cref="UsualUs"/>, than at any other offset: most clocks are right.</summary>
        private const double KnownWeight = 200;
        private const long StepUs = 10_000;
        private const int Steps = (int)(2 * ReachUs / StepUs) + 1;

        /// <summary>Shots wait until camera 1 has been seen that long after them.</summary>
        private const long RipeUs = ReachUs + 40_000;
        private const int MaxWaiting = 16;

        /// <summary>
        /// Shots that count: with four shooters those of a minute and a half, with one of six, in which a hundred parts in a million make 9 and 36 ms.
        /// </summary>
        private const int MaxShots = 24;

        /// <summary>
        /// Nothing is said before it is known that well. Whatever is likely beside the best counts in it: another offset 100 ms away that has a hundredth
        /// of the probability already makes 10 ms.
        /// </summary>
        private const double MaxSigmaUs = 10_000;

        /// <summary>Smaller than this, or than so many of its standard deviations, an error is left alone: hands hold still longer.</summary>
        private const double MinOffsetUs = 8_000;
        private const double MinSigmas = 3;

        /// <summary>Better it is never known: what a line of sight errs is common to all its shots.</summary>
        private const double LeastSigmaUs = 4_000;

        private readonly Waiting[] _waiting = new Waiting[MaxWaiting];
        private readonly SwingShot[] _shots = new SwingShot[MaxShots];
        private readonly double[] _fits = new double[MaxShots * Steps];
        private readonly double[] _fit = new double[Steps];
        private readonly HandCamera _camera;
        private int _waitingCount;
        private int _count;
        private int _next;
        private int _again;
        private int _due;
        private long _centreUs;

        public HandClock(HandCamera camera)
        {
            _camera = camera;
            for (int i = 0; i < MaxShots; i++)
                _shots[i] = new SwingShot();
        }

        /// <summary>Camera 1's clock minus camera 0's as known so far, microseconds; positive: its pictures are stamped late.</summary>
        public long OffsetUs { get; private set; }

        /// <summary>Standard deviation of that, microseconds; 0 while nothing has told.</summary>
        public long SigmaUs { get; private set; }

        /// <summary>Probability that the clock is as known to within <see cref="UsualUs"/>: one that is farther off names the wrong ones.</summary>
        public double KnownProbability { get; private set; } = 1;

        public void Clear()
        {
            KnownProbability = 1;
            _waitingCount = _count = _next = _again = _due = 0;
            OffsetUs = SigmaUs = _centreUs = 0;
        }

        /// <summary>Notes a shot whose dot moves.</summary>
        public void Note(long timeUs, long timeSigmaUs, Vector3D dotM)
        {
            if (_waitingCount < MaxWaiting)
                _waiting[_waitingCount++] = new Waiting { TimeUs = timeUs, TimeSigmaUs = timeSigmaUs, DotM = dotM };
        }

        /// <summary>Another shot has shown somebody's line of sight: one of those that are kept is due to be weighed again.</summary>
        public void NoteLine() => _due = Math.Min(_due + 1, MaxShots);

        /// <summary>Weighs one shot at most.</summary>
        /// <param name="nowUs">Time of camera 1's last picture, corrected.</param>
        /// <param name="history">Corrected times; moved when the clock is known better.</param>
        /// <param name="sights">Where everybody aims over.</param>
        public void Update(long nowUs, HandHistory history, SightLines sights)
        {
            if (_waitingCount > 0 && nowUs - _waiting[0].TimeUs >= RipeUs)
            {
                Waiting shot = _waiting[0];
                Array.Copy(_waiting, 1, _waiting, 0, --_waitingCount);
                _shots[_next].Take(shot.TimeUs, shot.TimeSigmaUs, shot.DotM, RipeUs, history, OffsetUs, _camera);
                Weigh(_next, sights);
                _next = (_next + 1) % MaxShots;
                _count = Math.Min(_count + 1, MaxShots);
            }
            else if (_due > 0 && _count > 0)
            {
                _due--;
                _again = (_again + 1) % _count;
                Weigh(_again, sights);
            }
            else
            {
                return;
            }

            if (TryEstimate(out double offsetUs, out double sigmaUs))
                Correct((long)Math.Round(offsetUs), (long)Math.Round(sigmaUs), history, sights);
        }

        private void Weigh(int shot, SightLines sights) =>
            _shots[shot].Weigh(sights, _centreUs - ReachUs, StepUs, new Span<double>(_fits, shot * Steps, Steps));

        /// <summary>Mean and standard deviation of the offset; false where that says nothing new.</summary>
        private bool TryEstimate(out double offsetUs, out double sigmaUs)
        {
            Array.Clear(_fit, 0, Steps);
            for (int shot = 0; shot < _count; shot++)
            {
                for (int step = 0, at = shot * Steps; step < Steps; step++)
                    _fit[step] += _fits[at + step];
            }

            double best = double.MinValue;
            for (int step = 0; step < Steps; step++)
            {
                if (Math.Abs(OffsetAt(step)) > UsualUs)
                    _fit[step] += LogFarShare;
                best = Math.Max(best, _fit[step]);
            }

            double sum = 0, known = 0, first = 0, second = 0;
            for (int step = 0; step < Steps; step++)
            {
                // Less than that of the best is nothing beside it.
                if (_fit[step] < best - MaxDifference)
                    continue;
                double probability = Math.Exp(_fit[step] - best), at = step * StepUs - ReachUs;
                sum += probability;
                first += probability * at;
                second += probability * at * at;
                if (Math.Abs(OffsetAt(step) - OffsetUs) <= UsualUs)
                    known += probability;
            }

            KnownProbability = KnownWeight * known / (KnownWeight * known + sum - known);
            double mean = first / sum;
            offsetUs = _centreUs + mean;
            sigmaUs = Math.Max(LeastSigmaUs, Math.Sqrt(Math.Max(0, second / sum - mean * mean)));
            return sigmaUs <= MaxSigmaUs && Math.Abs(mean) <= ReachUs - EdgeUs && Math.Abs(offsetUs - OffsetUs) >= Math.Max(MinOffsetUs, MinSigmas * sigmaUs);
        }

        private long OffsetAt(int step) => _centreUs + step * StepUs - ReachUs;

        private void Correct(long offsetUs, long sigmaUs, HandHistory history, SightLines sights)
        {
            history.Shift(OffsetUs - offsetUs);
            OffsetUs = offsetUs;
            SigmaUs = sigmaUs;
            KnownProbability = 1;
            if (Math.Abs(offsetUs - _centreUs) < ReachUs / 4)
                return;
            _centreUs = offsetUs;
            for (int i = 0; i < _count; i++)
                Weigh(i, sights);
        }
    }
}
