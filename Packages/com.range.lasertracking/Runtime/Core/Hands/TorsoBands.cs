using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>One surface's body, and what stands out before it. One band: sums of fractions go from cell to cell.</summary>
    internal unsafe struct TorsoBands : IKernelBands
    {
        public int Width;
        public float* Z;
        public float* RayX;
        public float* RayY;

        /// <summary>The surface's; one at least.</summary>
        public int* Cells;
        public int CellCount;

        /// <summary>Half a shoulder's width, columns.</summary>
        public int Reach;
        public double DepthBinMm;

        /// <summary><see cref="TorsoKernel.ColumnBins"/>.</summary>
        public TorsoColumn* Columns;

        /// <summary>Scratch, <see cref="TorsoKernel.DepthBins"/> for each column.</summary>
        public int* Histogram;

        /// <summary>Scratch, <see cref="TorsoKernel.DepthBins"/>.</summary>
        public int* Window;
        public float ForwardMm;

        /// <summary>Given to cells that stand out farther than that.</summary>
        public byte NextLevel;
        public byte* Levels;
        public float* Before;

        /// <summary>By how much z grows downwards on the body.</summary>
        public double Slope;

        public void Execute(int band)
        {
            Slope = TorsoKernel.Slope(this);
            TorsoKernel.FindBody(this);
            TorsoKernel.MarkForward(this);
        }
    }
}
