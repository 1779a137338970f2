using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The past's levels replaced by those of a table; a band is a row.</summary>
    internal unsafe struct RescaleBands : IKernelBands
    {
        public int Width;

        /// <summary>256 levels.</summary>
        public byte* Table;
        public byte* Smallest;
        public byte* Largest;
        public uint* Picture;

        public void Execute(int row)
        {
            long first = (long)row * Width;
            Replace(Smallest + first, Width);
            Replace(Largest + first, Width);
            Replace((byte*)(Picture + first), 4 * Width);
        }

        private void Replace(byte* levels, int count)
        {
            byte* table = Table;
            for (int i = 0; i < count; i++)
                levels[i] = table[levels[i]];
        }
    }
}
