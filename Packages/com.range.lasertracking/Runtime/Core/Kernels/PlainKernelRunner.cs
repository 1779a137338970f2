using LaserTracking.Detection;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;

namespace LaserTracking.Kernels
{
    /// <summary>All bands one after the other, on the calling thread.</summary>
    internal sealed unsafe class PlainKernelRunner : KernelRunner
    {
        internal override int BandCount => 1;

        internal override void Run(PlaneBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(DilationBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(PaperBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(PatchBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(PatchMatchBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(RatioBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(HistogramBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(RescaleBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(RiseBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(RaiseBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(ExpectationBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(ComparisonBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(InfraredTileBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(GreenTileBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(DepthGridBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(BridgeBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(DepthLevelBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(SurfaceBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(TorsoBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(CropBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(ExposureBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(ConvolutionBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(DepthwiseBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(AddBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }

        internal override void Run(MaxPoolBands* work, int count)
        {
            for (int band = 0; band < count; band++)
                work->Execute(band);
        }
    }
}
