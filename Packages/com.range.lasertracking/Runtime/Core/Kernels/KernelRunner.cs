using LaserTracking.Detection;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;

namespace LaserTracking.Kernels
{
    /// <summary>
    /// Runs the heavy kernels: the calling thread itself here, Burst jobs in Unity. Each call returns when all bands are done. Bands
    /// write to different places, so neither their order nor their number changes a result by a bit. The structs hold pointers and
    /// numbers only, and what they call allocates nothing, throws nothing and touches no object.
    /// </summary>
    public abstract unsafe class KernelRunner
    {
        /// <summary>The calling thread, one band.</summary>
        public static KernelRunner Plain { get; } = new PlainKernelRunner();

        /// <summary>Into how many bands work is cut whose bands need scratch memory; 1 or more, always the same.</summary>
        internal abstract int BandCount { get; }

        internal abstract void Run(PlaneBands* work, int count);

        internal abstract void Run(DilationBands* work, int count);

        internal abstract void Run(PaperBands* work, int count);

        internal abstract void Run(PatchBands* work, int count);

        internal abstract void Run(PatchMatchBands* work, int count);

        internal abstract void Run(RatioBands* work, int count);

        internal abstract void Run(HistogramBands* work, int count);

        internal abstract void Run(RescaleBands* work, int count);

        internal abstract void Run(RiseBands* work, int count);

        internal abstract void Run(ExpectationBands* work, int count);

        internal abstract void Run(ComparisonBands* work, int count);

        internal abstract void Run(InfraredTileBands* work, int count);

        internal abstract void Run(GreenTileBands* work, int count);

        internal abstract void Run(DepthGridBands* work, int count);

        internal abstract void Run(BridgeBands* work, int count);

        internal abstract void Run(DepthLevelBands* work, int count);

        internal abstract void Run(SurfaceBands* work, int count);

        internal abstract void Run(TorsoBands* work, int count);

        internal abstract void Run(CropBands* work, int count);

        internal abstract void Run(ExposureBands* work, int count);

        internal abstract void Run(ConvolutionBands* work, int count);

        internal abstract void Run(DepthwiseBands* work, int count);

        internal abstract void Run(AddBands* work, int count);

        internal abstract void Run(MaxPoolBands* work, int count);
    }
}
