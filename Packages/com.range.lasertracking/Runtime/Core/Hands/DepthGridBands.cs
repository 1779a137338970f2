using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>A depth picture gathered into cells; a band is a row of cells.</summary>
    internal unsafe struct DepthGridBands : IKernelBands
    {
        public PictureView Source;
        public int Width;
        public int StepPx;

        /// <summary>Of a cell's pixels the two that are read, along either side.</summary>
        public int FirstPx;
        public int SecondPx;
        public float NearMm;
        public float FarMm;
        public float SurfaceStepMm;
        public float* Z;
        public bool* Lost;

        public void Execute(int row)
        {
            byte* top = Source.Row(row * StepPx + FirstPx), bottom = Source.Row(row * StepPx + SecondPx);
#if NET8_0_OR_GREATER
            DepthGridKernel.Announce(top + (long)StepPx * Source.Stride, 2 * Source.Width);
            DepthGridKernel.Announce(bottom + (long)StepPx * Source.Stride, 2 * Source.Width);
#endif
            long cells = (long)row * Width;
            DepthGridKernel.Row((ushort*)top, (ushort*)bottom, Width, StepPx, FirstPx, SecondPx, NearMm, FarMm, SurfaceStepMm, Z + cells, Lost + cells);
        }
    }
}
