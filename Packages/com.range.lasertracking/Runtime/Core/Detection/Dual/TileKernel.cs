namespace LaserTracking.Detection
{
    /// <summary>
    /// One number for every 8×8 pixels of a band of rows: brightest infrared count, or greatest green excess. The scalar and the
    /// vector form agree to the bit. A last tile may be narrower, a last band lower.
    /// </summary>
    internal static unsafe partial class TileKernel
    {
        public const int Size = 8;

        public static int Count(int lengthPx) => (lengthPx + Size - 1) / Size;

        /// <summary>Largest of 16-bit samples; rows of one band, at most <see cref="Size"/>.</summary>
        public static void Brightest(byte* band, long stride, int rows, int width, ushort* tiles, bool useVectors)
        {
            int done = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                done = BrightestVector(band, stride, rows, width, tiles);
#endif
            for (int tile = done; tile < Count(width); tile++)
            {
                int largest = 0, right = tile * Size + Size < width ? tile * Size + Size : width;
                for (int y = 0; y < rows; y++)
                {
                    ushort* row = (ushort*)(band + y * stride);
                    for (int x = tile * Size; x < right; x++)
                        largest = row[x] > largest ? row[x] : largest;
                }

                tiles[tile] = (ushort)largest;
            }
        }

        /// <summary>Largest excess of green over the larger of red and blue, 0…255, of B G R A pixels; rows as above.</summary>
        public static void Greenest(byte* band, long stride, int rows, int width, byte* tiles, bool useVectors)
        {
            int done = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                done = GreenestVector(band, stride, rows, width, tiles);
#endif
            for (int tile = done; tile < Count(width); tile++)
            {
                int largest = 0, right = tile * Size + Size < width ? tile * Size + Size : width;
                for (int y = 0; y < rows; y++)
                {
                    uint* row = (uint*)(band + y * stride);
                    for (int x = tile * Size; x < right; x++)
                    {
                        int excess = GreenExcess(row[x]);
                        largest = excess > largest ? excess : largest;
                    }
                }

                tiles[tile] = (byte)largest;
            }
        }

        /// <summary>Green minus the larger of red and blue; may be negative.</summary>
        public static int GreenExcess(uint pixel)
        {
            int blue = (int)(pixel & 255), green = (int)(pixel >> 8 & 255), red = (int)(pixel >> 16 & 255);
            return green - (red > blue ? red : blue);
        }
    }
}
