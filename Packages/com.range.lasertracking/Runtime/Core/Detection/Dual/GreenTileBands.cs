using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The greatest green excess of every 8×8 pixels in some rows of tiles; a band is a share of those rows.</summary>
    internal unsafe struct GreenTileBands : IKernelBands
    {
        public PictureView Source;

        /// <summary>Rows of tiles that are looked at: First, First + Step …, Count of them.</summary>
        public int First;
        public int Step;
        public int Count;
        public int BandCount;
        public bool UseVectors;
        public byte* Tiles;

        /// <summary>Scratch, 8 rows of pixels for each band; unused for pictures that are BGRA already.</summary>
        public uint* Rows;

        public void Execute(int band)
        {
            int end = (int)((long)Count * (band + 1) / BandCount);
            uint* rows = Rows + (long)band * TileKernel.Size * Source.Width;
            for (int i = (int)((long)Count * band / BandCount); i < end; i++)
                Reduce(First + i * Step, rows);
        }

        private void Reduce(int tileRow, uint* converted)
        {
            int y = tileRow * TileKernel.Size, rows = Source.Height - y < TileKernel.Size ? Source.Height - y : TileKernel.Size;
            byte* pixels = Source.Row(y);
            long stride = Source.Stride;
            if (Source.Format != PixelFormat.Bgra32)
            {
                pixels = (byte*)converted;
                stride = 4L * Source.Width;
                for (int i = 0; i < rows; i++)
                    ReductionKernel.Row(Source, y + i, 1, converted + (long)i * Source.Width, UseVectors);
            }

            TileKernel.Greenest(pixels, stride, rows, Source.Width, Tiles + (long)tileRow * TileKernel.Count(Source.Width), UseVectors);
        }
    }
}
