namespace LaserTracking.Detection
{
    /// <summary>
    /// One row of the background: for the smallest and for the largest channel of each pixel, the maximum of the recent past that
    /// decays by a fixed step a frame. What rises above it by more than a sixteenth of the room left to full brightness is the
    /// pixel's onset; its maximum over the rows of a tile is kept per column. Scalar form here, vectors in the other part.
    /// </summary>
    internal static unsafe partial class EnvelopeKernel
    {
        /// <summary>The excess over this share of the headroom counts: headroom shifted right by this.</summary>
        public const int HeadroomShift = 4;

        /// <param name="pixels">Working picture's row: blue, green, red, any.</param>
        /// <param name="width">Pixels in the row and bytes in every other array.</param>
        /// <param name="decay">Levels by which the past fades, 0…255.</param>
        /// <param name="oldMin">Envelope of the smallest channel before this frame.</param>
        /// <param name="newMin">The same after it; may not be the same memory.</param>
        /// <param name="oldMax">Envelope of the largest channel before this frame.</param>
        /// <param name="newMax">The same after it.</param>
        /// <param name="columnMin">Largest onset of the smallest channel by column; raised, never cleared here.</param>
        /// <param name="columnMax">The same for the largest channel.</param>
        /// <param name="useVectors">False: scalar only, for comparison.</param>
        public static void Row(
            uint* pixels, int width, byte decay, byte* oldMin, byte* newMin, byte* oldMax, byte* newMax, byte* columnMin, byte* columnMax, bool useVectors)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = RowVector(pixels, width, decay, oldMin, newMin, oldMax, newMax, columnMin, columnMax);
#endif
            for (; x < width; x++)
            {
                int blue = (int)(pixels[x] & 255), green = (int)(pixels[x] >> 8 & 255), red = (int)(pixels[x] >> 16 & 255);
                int smallest = blue < green ? blue : green;
                smallest = red < smallest ? red : smallest;
                int largest = blue > green ? blue : green;
                largest = red > largest ? red : largest;
                Pixel(smallest, decay, oldMin[x], newMin + x, columnMin + x);
                Pixel(largest, decay, oldMax[x], newMax + x, columnMax + x);
            }
        }

        private static void Pixel(int level, int decay, int old, byte* next, byte* column)
        {
            int onset = level - old - (255 - old >> HeadroomShift);
            int faded = old > decay ? old - decay : 0;
            *next = (byte)(level > faded ? level : faded);
            *column = (byte)(onset > *column ? onset : *column);
        }
    }
}
