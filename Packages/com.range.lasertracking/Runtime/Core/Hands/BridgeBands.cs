using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>Short holes of a grid bridged along lines of cells, rows or columns; a band is a line.</summary>
    internal unsafe struct BridgeBands : IKernelBands
    {
        public float* Z;
        public bool* Lost;

        /// <summary>Cells of a line.</summary>
        public int Length;

        /// <summary>From one cell of a line to the next.</summary>
        public int Stride;

        /// <summary>From one line to the next.</summary>
        public int LineStride;

        /// <summary>Cells at a distance of 1 mm that a hole may be long.</summary>
        public float Reach;
        public float SurfaceStepMm;

        public void Execute(int line)
        {
            long first = (long)line * LineStride;
            DepthGridKernel.Bridge(Z + first, Lost + first, Length, Stride, Reach, SurfaceStepMm);
        }
    }
}
