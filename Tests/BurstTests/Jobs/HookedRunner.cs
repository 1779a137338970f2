using System;
using LaserTracking.Detection;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Kernels;

namespace LaserTracking.Burst
{
    /// <summary>Puts a test between a kernel and its runner.</summary>
    internal sealed unsafe class HookedRunner : KernelRunner
    {
        private readonly KernelRunner _inner;
        private readonly Action<Action> _hook;

        public HookedRunner(KernelRunner inner, Action<Action> hook)
        {
            _inner = inner;
            _hook = hook;
        }

        internal override int BandCount => _inner.BandCount;

        internal override void Run(PlaneBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(DilationBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(PaperBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(PatchBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(PatchMatchBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(RatioBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(HistogramBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(RescaleBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(RiseBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(ExpectationBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(ComparisonBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(InfraredTileBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(GreenTileBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(DepthGridBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(BridgeBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(DepthLevelBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(SurfaceBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(TorsoBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(CropBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(ExposureBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(ConvolutionBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(DepthwiseBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(AddBands* work, int count) => _hook(() => _inner.Run(work, count));

        internal override void Run(MaxPoolBands* work, int count) => _hook(() => _inner.Run(work, count));
    }
}
