using System;

namespace LaserTracking.Session
{
    /// <summary>
    /// The blind share of the screen over a session's time, in fixed room: equal steps that double in length when the session
    /// outgrows them. No allocation per frame.
    /// </summary>
    public sealed class BlindTimeline
    {
        private const int MostSteps = 512;
        private const long FirstStepUs = 100_000;
        private readonly double[] _sums = new double[MostSteps];
        private readonly int[] _counts = new int[MostSteps];
        private long _beginUs;

        /// <summary>Steps with a frame in them or before.</summary>
        public int Count { get; private set; }

        /// <summary>Length of a step, microseconds.</summary>
        public long StepUs { get; private set; } = FirstStepUs;

        /// <summary>Time at which a step begins, microseconds on the recording's clock.</summary>
        public long BeginUs(int step) => _beginUs + step * StepUs;

        /// <summary>Mean over the step's frames, 0…1; 0 for a step without frames.</summary>
        public double MeanShare(int step) => _counts[step] == 0 ? 0 : _sums[step] / _counts[step];

        /// <summary>Adds a frame; times that lie before the first are taken for the first.</summary>
        public void Add(long timeUs, double blindShare)
        {
            if (Count == 0)
                _beginUs = timeUs;
            long since = Math.Max(0, timeUs - _beginUs);
            while (since / StepUs >= MostSteps)
                Halve();
            int step = (int)(since / StepUs);
            _sums[step] += blindShare;
            _counts[step]++;
            Count = Math.Max(Count, step + 1);
        }

        private void Halve()
        {
            for (int i = 0; i < MostSteps; i++)
            {
                bool isKept = i < MostSteps / 2;
                _sums[i] = isKept ? _sums[2 * i] + _sums[2 * i + 1] : 0;
                _counts[i] = isKept ? _counts[2 * i] + _counts[2 * i + 1] : 0;
            }

            StepUs *= 2;
            Count = (Count + 1) / 2;
        }
    }
}
