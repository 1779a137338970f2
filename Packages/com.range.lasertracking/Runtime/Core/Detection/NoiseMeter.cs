using System;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The picture's temporal noise from the median change of a sparse grid of pixels: what moves is the smaller part of them.</summary>
    internal sealed class NoiseMeter
    {
        /// <summary>Pixels looked at, at least: the median of so many is known to two per cent.</summary>
        private const int Samples = 5000;

        private const double Follow = 0.2;
        private readonly LevelHistogram _histogram;
        private bool _isFirst = true;

        public NoiseMeter(KernelRunner kernels) => _histogram = new LevelHistogram(kernels);

        /// <summary>Standard deviation of one frame, levels; never below half a level, the rounding's share.</summary>
        public double Sigma { get; private set; } = 1;

        public void Reset()
        {
            _isFirst = true;
            Sigma = 1;
        }

        /// <summary>The picture's treatment has changed its noise by this factor.</summary>
        public void Scale(double factor) => Sigma *= factor;

        public void Update(in FrameView view)
        {
            int count = _histogram.Count(view, true, Math.Max(1, (int)Math.Sqrt((double)view.Width * view.Height / Samples)));
            if (count == 0)
                return;
            ReadOnlySpan<int> histogram = _histogram.Counts;
            int level = 0, below = 0;
            while (level < 255 && 2 * (below + histogram[level]) < count)
                below += histogram[level++];

            // Interpolated inside the bin; |difference of two| has its median at 0.954 sigma.
            double inside = (count * 0.5 - below) / Math.Max(1, histogram[level]);
            double sigma = Math.Max(0.5, Math.Max(0, level - 0.5 + inside) / 0.954);
            Sigma = _isFirst ? sigma : Sigma + Follow * (sigma - Sigma);
            _isFirst = false;
        }
    }
}
