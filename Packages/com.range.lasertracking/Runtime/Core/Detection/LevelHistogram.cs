using System;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Runs <see cref="HistogramBands"/> and adds up what they counted.</summary>
    internal sealed unsafe class LevelHistogram
    {
        private readonly KernelRunner _kernels;
        private readonly int[] _counts;

        public LevelHistogram(KernelRunner kernels)
        {
            _kernels = kernels;
            _counts = new int[HistogramBands.Levels * kernels.BandCount];
        }

        /// <summary>Samples of the last count by level, 0…255.</summary>
        public ReadOnlySpan<int> Counts => new ReadOnlySpan<int>(_counts, 0, HistogramBands.Levels);

        /// <summary>Counts anew; returns the number of samples.</summary>
        public int Count(in FrameView view, bool isOfChange, int step)
        {
            fixed (int* histograms = _counts)
            {
                var work = new HistogramBands { View = view, IsOfChange = isOfChange, Step = step, BandCount = _kernels.BandCount, Histograms = histograms };
                _kernels.Run(&work, work.BandCount);
            }

            int count = 0;
            for (int i = 0; i < _counts.Length; i++)
            {
                count += _counts[i];
                if (i >= HistogramBands.Levels)
                    _counts[i % HistogramBands.Levels] += _counts[i];
            }

            return count;
        }
    }
}
