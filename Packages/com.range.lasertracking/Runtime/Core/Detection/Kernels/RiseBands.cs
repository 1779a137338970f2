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

        public void Execute(int slot)
        {
            int x0 = Tiles[slot] % TileColumns * TileGrid.Size, y0 = Tiles[slot] / TileColumns * TileGrid.Size;
            int x1 = x0 + TileGrid.Size < View.Width ? x0 + TileGrid.Size : View.Width, y1 = y0 + TileGrid.Size < View.Height ? y0 + TileGrid.Size : View.Height;

            // In variables: what is written through a pointer could be this very structure.
            uint* now = View.Now;
            byte* past = Plane == DetectionPlane.Smallest ? View.OldSmallest : View.OldLargest;
            int* reciprocal = View.Reciprocal;
            DetectionPlane plane = Plane;
            for (int y = y0; y < y1; y++)
            {
                byte* to = Rises + (slot * TileGrid.Size + y - y0) * TileGrid.Size;
                for (int i = y * View.Width + x0; i < y * View.Width + x1; i++)
                    *to++ = (byte)FrameView.RelativeRise(now[i], plane, past[i], reciprocal);
            }
        }
    }
}
