using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The working picture against what is expected of it: reference levels and the tiles' excess. A band is a share of the rows of tiles.</summary>
    internal unsafe struct ComparisonBands : IKernelBands
    {
        public int Width;
        public int Height;
        public int BlockColumns;
        public bool UseVectors;
        public int BandCount;
        public uint* Now;
        public uint* Screen;
        public int* Blocks;
        public byte* Reference;
        public byte* Onsets;

        /// <summary>Scratch, twice the block columns for each band.</summary>
        public uint* Row;

        /// <summary>Scratch, width for each band.</summary>
        public byte* Columns;

        public void Execute(int band)
        {
            int tileRows = TileGrid.Count(Height), first = (int)((long)tileRows * band / BandCount), end = (int)((long)tileRows * (band + 1) / BandCount);
            uint* expected = Row + (long)band * 2 * BlockColumns;
            byte* columns = Columns + (long)band * Width;
            for (int tileRow = first; tileRow < end; tileRow++)
            {
                PixelMemory.Clear(columns, Width);
                int bottom = (tileRow + 1) * TileGrid.Size < Height ? (tileRow + 1) * TileGrid.Size : Height;
                for (int y = tileRow * TileGrid.Size; y < bottom; y++)
                {
                    long row = (long)y * Width;
                    if (y % 2 == 0)
                        ExpectationKernel.Gather(Screen, Blocks + (long)(y / 2) * BlockColumns, BlockColumns, expected, UseVectors);
                    ExpectationKernel.Exceed(Now + row, expected, Width, Reference + row, columns, UseVectors);
                }

                TileGrid.ReduceRow(columns, Width, Onsets + (long)tileRow * TileGrid.Count(Width));
            }
        }
    }
}
