using LaserTracking.Detection;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;

namespace LaserTracking.Kernels
{
    /// <summary>All bands one after the other, on the calling thread.</summary>
    internal sealed unsafe class PlainKernelRunner : KernelRunner
    {
        internal override int BandCount => 1;

        internal override void Run(PlaneBands* work, int count) => RunBands(work, count);

        internal override void Run(DilationBands* work, int count) => RunBands(work, count);

        internal override void Run(PaperBands* work, int count) => RunBands(work, count);

        internal override void Run(PatchBands* work, int count) => RunBands(work, count);

        internal override void Run(PatchMatchBands* work, int count) => RunBands(work, count);

        internal override void Run(RatioBands* work, int count) => RunBands(work, count);

        internal override void Run(HistogramBands* work, int count) => RunBands(work, count);

        internal override void Run(RescaleBands* work, int count) => RunBands(work, count);

        internal override void Run(RiseBands* work, int count) => RunBands(work, count);

        internal override void Run(ExpectationBands* work, int count) => RunBands(work, count);

        internal override void Run(ComparisonBands* work, int count) => RunBands(work, count);

        internal override void Run(InfraredTileBands* work, int count) => RunBands(work, count);

        internal override void Run(GreenTileBands* work, int count) => RunBands(work, count);

        internal override void Run(DepthGridBands* work, int count) => RunBands(work, count);

        internal override void Run(BridgeBands* work, int count) => RunBands(work, count);

        internal override void Run(DepthLevelBands* work, int count) => RunBands(work, count);

        internal override void Run(SurfaceBands* work, int count) => RunBands(work, count);

        internal override void Run(TorsoBands* work, int count) => RunBands(work, count);

        internal override void Run(CropBands* work, int count) => RunBands(work, count);

        internal override void Run(ExposureBands* work, int count) => RunBands(work, count);

        internal override void Run(ConvolutionBands* work, int count) => RunBands(work, count);

        internal override void Run(DepthwiseBands* work, int count) => RunBands(work, count);

        internal override void Run(AddBands* work, int count) => RunBands(work, count);

        internal override void Run(MaxPoolBands* work, int count) => RunBands(work, count);

        private static void RunBands<T>(T* work, int count)
            where T : unmanaged, IKernelBands
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }
    }
}
