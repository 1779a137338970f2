using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Relative rises of the pixels in chosen tiles; a band is a tile.</summary>
    internal unsafe struct RiseBands : IKernelBands
    {
        public FrameView View;
        public DetectionPlane Plane;

        /// <summary>Tiles in a row.</summary>
        public int TileColumns;

        /// <summary>Which ones.</summary>
        public int* Tiles;

        /// <summary>A tile's pixels for each, row by row; those beyond the border are left as they are.</summary>
        public byte* Rises;

        /// <summary>The highest of each of a tile's rows.</summary>
        public byte* Peaks;

        public void Execute(int slot)
        {
            int x0 = Tiles[slot] % TileColumns * TileGrid.Size, y0 = Tiles[slot] / TileColumns * TileGrid.Size;
            int x1 = x0 + TileGrid.Size < View.Width ? x0 + TileGrid.Size : View.Width, y1 = y0 + TileGrid.Size < View.Height ? y0 + TileGrid.Size : View.Height;

            int first = y0 * View.Width + x0;
            RiseKernel.Tile(View.Now + first, View.Past(Plane) + first, View.Width, Plane, View.Reciprocal, x1 - x0, y1 - y0,
                Rises + slot * TileGrid.Size * TileGrid.Size, Peaks + slot * TileGrid.Size);
        }
    }
}
