using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Largest byte of each pixel and its eight neighbours; a band is a row.</summary>
    internal unsafe struct DilationBands : IKernelBands
    {
        public byte* Source;
        public byte* Target;
        public int Width;
        public int Height;

        public void Execute(int y)
        {
            long row = (long)y * Width;
            byte* above = Source + (y > 0 ? row - Width : row), below = Source + (y + 1 < Height ? row + Width : row);
            DilationKernel.Row(above, Source + row, below, Width, Target + row);
        }
    }
}
