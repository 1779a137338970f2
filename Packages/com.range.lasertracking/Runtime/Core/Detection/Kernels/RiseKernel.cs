namespace LaserTracking.Detection
{
    /// <summary>Relative rises of the pixels of one tile, and each row's highest. Scalar form here, vectors in the other part; equal to the bit.</summary>
    internal static unsafe partial class RiseKernel
    {
        /// <param name="now">First pixel of the tile.</param>
        /// <param name="past">What that pixel's past explains.</param>
        /// <param name="stride">From row to row of both.</param>
        /// <param name="plane">Channel looked at.</param>
        /// <param name="reciprocal">By headroom, of <see cref="FrameView.Reciprocals"/>.</param>
        /// <param name="width">Pixels of a row inside the picture, at most <see cref="TileGrid.Size"/>.</param>
        /// <param name="height">Rows inside the picture.</param>
        /// <param name="rises">A tile's, row by row; those beyond the border are left as they are.</param>
        /// <param name="peaks">The highest of each row.</param>
        public static void Tile(uint* now, byte* past, int stride, DetectionPlane plane, int* reciprocal, int width, int height, byte* rises, byte* peaks)
        {
            int y = 0;
#if NET8_0_OR_GREATER
            if (width == TileGrid.Size)
                y = TileVector(now, past, stride, plane, reciprocal, height, rises, peaks);
#endif
            for (; y < height; y++)
            {
                int peak = 0;
                for (int x = 0; x < width; x++)
                {
                    int rise = FrameView.RelativeRise(now[y * stride + x], plane, past[y * stride + x], reciprocal);
                    rises[y * TileGrid.Size + x] = (byte)rise;
                    peak = rise > peak ? rise : peak;
                }

                peaks[y] = (byte)peak;
            }
        }
    }
}
