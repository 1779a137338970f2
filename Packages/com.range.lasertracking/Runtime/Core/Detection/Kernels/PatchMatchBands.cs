using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Where each patch's content has gone since it was remembered; a band is a patch.</summary>
    internal unsafe struct PatchMatchBands : IKernelBands
    {
        public double Gain;
        public double Noise;
        public int* Columns;
        public int* Rows;

        /// <summary>Slopes remembered, <see cref="PatchKernel.Size"/> for each patch.</summary>
        public float* ColumnReference;
        public float* RowReference;

        /// <summary>Working px; NaN where there is nothing to hold on to.</summary>
        public double* ShiftX;
        public double* ShiftY;

        public void Execute(int patch)
        {
            ShiftX[patch] = PatchKernel.Match(Columns + patch * PatchKernel.Window, ColumnReference + patch * PatchKernel.Size, Gain, Noise);
            ShiftY[patch] = PatchKernel.Match(Rows + patch * PatchKernel.Window, RowReference + patch * PatchKernel.Size, Gain, Noise);
        }
    }
}
