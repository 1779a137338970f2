using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>The brightest count of every 8×8 pixels of an infrared picture; a band is a row of tiles.</summary>
    internal unsafe struct InfraredTileBands : IKernelBands
    {
        public PictureView Source;
        public ushort* Tiles;
        public bool UseVectors;

        public void Execute(int tileRow)
        {
            int y = tileRow * TileKernel.Size, rows = Source.Height - y < TileKernel.Size ? Source.Height - y : TileKernel.Size;
            TileKernel.Brightest(Source.Row(y), Source.Stride, rows, Source.Width, Tiles + (long)tileRow * TileKernel.Count(Source.Width), UseVectors);
        }
    }
}
