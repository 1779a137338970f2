using System;

namespace LaserTracking.Session
{
    /// <summary>
    /// What the frames of a session cost and showed, in fixed room: a histogram of processing times with 32 steps a factor of ten
    /// (percentiles are right to 4 %) and the share of the picture in which no dot could be seen. No allocation per frame.
    /// </summary>
    public sealed class FrameStatistics
    {
        private const int StepsPerDecade = 32;
        private const double SmallestMs = 0.001;
        private readonly int[] _histogram = new int[7 * StepsPerDecade];
        private double _blindSum;

        /// <summary>Frames added.</summary>
        public int Count { get; private set; }

        /// <summary>Frames added with a processing time.</summary>
        public int TimedCount { get; private set; }

        /// <summary>Frames in which some of the searched area was blind.</summary>
        public int BlindFrames { get; private set; }

        /// <summary>Mean over all frames of the blind share of the searched area, 0…1.</summary>
        public double MeanBlindShare => Count > 0 ? _blindSum / Count : 0;

        public double LargestBlindShare { get; private set; }

        public double MedianMs => Percentile(0.5);

        public double P95Ms => Percentile(0.95);

        public double LargestMs { get; private set; }

        /// <param name="blindShare">Share of the searched area in which a dot could not be seen, 0…1.</param>
        /// <param name="processingMs">Frame in to events out, milliseconds; NaN when it was not measured.</param>
        public void Add(double blindShare, double processingMs)
        {
            Count++;
            if (blindShare > 0)
            {
                BlindFrames++;
                _blindSum += blindShare;
                LargestBlindShare = Math.Max(LargestBlindShare, blindShare);
            }

            if (!(processingMs >= 0))
                return;
            TimedCount++;
            LargestMs = Math.Max(LargestMs, processingMs);
            double step = Math.Log10(Math.Max(processingMs, SmallestMs) / SmallestMs) * StepsPerDecade;
            _histogram[Math.Min((int)step, _histogram.Length - 1)]++;
        }

        private double Percentile(double share)
        {
            double wanted = share * TimedCount;
            int below = 0;
            for (int i = 0; i < _histogram.Length; i++)
            {
                below += _histogram[i];
                if (below > 0 && below >= wanted)
                    return Math.Min(LargestMs, SmallestMs * Math.Pow(10, (i + 0.5) / StepsPerDecade));
            }

            return 0;
        }
    }
}
