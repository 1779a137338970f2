using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The brightest rendered picture, widened and as the camera would show it. A band is a share of its rows.</summary>
    internal unsafe struct ExpectationBands : IKernelBands
    {
        public int Width;
        public int Height;
        public bool UseVectors;
        public int BandCount;
        public uint* Brightest;
        public uint* Screen;
        public byte* Tone;
        public uint* Gain;
        public uint* Offset;

        /// <summary>Scratch, width + 4 for each band, zero at its ends.</summary>
        public uint* Pad;

        public void Execute(int band)
        {
            int first = (int)((long)Height * band / BandCount), end = (int)((long)Height * (band + 1) / BandCount);
            uint* pad = Pad + (long)band * (Width + 2 * ExpectationKernel.Reach);
            for (int y = first; y < end; y++)
            {
                long row = (long)y * Width;
                ExpectationKernel.DilateRow(Brightest, Width, Height, y, pad, Screen + row, UseVectors);
                ExpectationKernel.Transfer(Screen + row, Width, Tone, Gain + row, Offset + row, UseVectors);
            }
        }
    }
}
