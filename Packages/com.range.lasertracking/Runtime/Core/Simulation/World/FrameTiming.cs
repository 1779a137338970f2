using System;
using System.Collections.Generic;

namespace LaserTracking.Simulation
{
    /// <summary>When a camera's frames were exposed and what its clock said. True times are µs since the beginning. Immutable.</summary>
    internal sealed class FrameTiming
    {
        private readonly double[] _midUs;
        private readonly int[] _exposures;
        private readonly double _offsetUs;
        private readonly double _rate;

        public FrameTiming(double startUs, double framesPerSecond, double durationS, double droppedShare, double clockOffsetUs,
            double clockDriftPpm, int seed, RandomStream dropStream)
        {
            var mid = new List<double>();
            var exposures = new List<int>();
            _offsetUs = clockOffsetUs;
            _rate = 1 + clockDriftPpm * 1e-6;
            for (int exposure = 0; ; exposure++)
            {
                double time = startUs + exposure * (1e6 / framesPerSecond);
                if (time >= durationS * 1e6)
                    break;
                if (droppedShare > 0 && CounterRandom.Uniform(seed, dropStream, exposure) < droppedShare)
                    continue;
                mid.Add(time);
                exposures.Add(exposure);
            }

            _midUs = mid.ToArray();
            _exposures = exposures.ToArray();
        }

        public int Count => _midUs.Length;

        /// <summary>True mid-exposure time of a delivered frame.</summary>
        public double MidUs(int frame) => _midUs[frame];

        /// <summary>Number of the exposure, dropped ones counted: the key of its noise.</summary>
        public int Exposure(int frame) => _exposures[frame];

        public long ClockUs(int frame) => ToClockUs(_midUs[frame]);

        public long ToClockUs(double trueUs) => (long)Math.Round(trueUs * _rate + _offsetUs);
    }
}
