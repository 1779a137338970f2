using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The brightest of some rendered pictures, widened and as the camera would show it. A band is a share of its rows.</summary>
    internal unsafe struct ExpectationBands : IKernelBands
    {
        /// <summary>Rows that a widened one is made of.</summary>
        private const int Diameter = 2 * ExpectationKernel.Reach + 1;

        public int Width;
        public int Height;
        public int PictureCount;
        public bool UseVectors;
        public int BandCount;

        /// <summary>One or more, rows without padding.</summary>
        public uint** Pictures;
        public uint* Screen;
        public byte* Tone;
        public uint* Gain;
        public uint* Offset;

        /// <summary>Scratch, <see cref="ScratchLength"/> for each band, zero at first.</summary>
        public uint* Scratch;

        /// <summary>Pixels of scratch for a band: the last rows, and the largest of them with what is beside the picture.</summary>
        public static int ScratchLength(int width) => (Diameter + 1) * width + 2 * ExpectationKernel.Reach;

        public void Execute(int band)
        {
            int first = (int)((long)Height * band / BandCount), end = (int)((long)Height * (band + 1) / BandCount);
            uint* pad = Scratch + (long)band * ScratchLength(Width), rows = pad + Width + 2 * ExpectationKernel.Reach;

            // Room for pointers of either size.
            ulong* places = stackalloc ulong[Diameter];
            var near = (uint**)places;
            for (int y = first; y < end; y++)
            {
                int top = y < ExpectationKernel.Reach ? 0 : y - ExpectationKernel.Reach;
                int bottom = y + ExpectationKernel.Reach < Height ? y + ExpectationKernel.Reach : Height - 1;
                for (int next = y == first ? top : y + ExpectationKernel.Reach; next <= bottom; next++)
                    ExpectationKernel.Brightest(Pictures, PictureCount, (long)next * Width, Width, rows + (long)(next % Diameter) * Width, UseVectors);
                for (int next = top; next <= bottom; next++)
                    near[next - top] = rows + (long)(next % Diameter) * Width;
                ExpectationKernel.Brightest(near, bottom - top + 1, 0, Width, pad + ExpectationKernel.Reach, UseVectors);
                long row = (long)y * Width;
                ExpectationKernel.Widen(pad, Width, Screen + row, UseVectors);
                ExpectationKernel.Transfer(Screen + row, Width, Tone, Gain + row, Offset + row, UseVectors);
            }
        }
    }
}
