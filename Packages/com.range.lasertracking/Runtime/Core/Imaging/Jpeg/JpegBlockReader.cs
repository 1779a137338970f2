using System;

namespace LaserTracking.Imaging
{
    /// <summary>Takes 8×8 samples, less 128, of one component out of a picture. Beyond the edge the last row and column repeat.</summary>
    internal static unsafe class JpegBlockReader
    {
        /// <param name="source">Bgra32, Nv12, Yuy2 or Gray8.</param>
        /// <param name="left">Column of the block's first sample.</param>
        /// <param name="top">Row of the block's first sample.</param>
        /// <param name="block">64 samples, row by row.</param>
        public static void ReadLuma(Image source, int left, int top, int* block)
        {
            bool isPacked = source.Format == PixelFormat.Yuy2;
            if (source.Format != PixelFormat.Bgra32 && left + 8 <= source.Width && top + 8 <= source.Height)
            {
                int step = isPacked ? 2 : 1;
                byte* inside = source.Pixels + (long)top * source.Stride + left * step;
                for (int y = 0; y < 8; y++, inside += source.Stride)
                {
                    for (int x = 0; x < 8; x++)
                        block[y * 8 + x] = inside[x * step] - 128;
                }

                return;
            }

            for (int y = 0; y < 8; y++)
            {
                byte* row = source.Pixels + (long)Math.Min(top + y, source.Height - 1) * source.Stride;
                for (int x = 0; x < 8; x++)
                {
                    int column = Math.Min(left + x, source.Width - 1);
                    int sample;
                    if (source.Format == PixelFormat.Bgra32)
                        sample = (19595 * row[4 * column + 2] + 38470 * row[4 * column + 1] + 7471 * row[4 * column] + 32768) >> 16;
                    else
                        sample = isPacked ? row[2 * column] : row[column];
                    block[y * 8 + x] = sample - 128;
                }
            }
        }

        /// <param name="source">Bgra32, Nv12 or Yuy2.</param>
        /// <param name="left">Column of the block's first sample in the chroma plane, which has half the picture's width.</param>
        /// <param name="top">Row of the block's first sample in the chroma plane.</param>
        /// <param name="component">1 = U (blue), 2 = V (red).</param>
        /// <param name="block">64 samples, row by row.</param>
        public static void ReadChroma(Image source, int left, int top, int component, int* block)
        {
            int lastColumn = (source.Width + 1) / 2 - 1;
            int lastRow = source.Format == PixelFormat.Nv12 ? source.Height / 2 - 1 : source.Height - 1;
            byte* plane = source.Format == PixelFormat.Nv12 ? source.Pixels + (long)source.Height * source.Stride : source.Pixels;
            for (int y = 0; y < 8; y++)
            {
                byte* row = plane + (long)Math.Min(top + y, lastRow) * source.Stride;
                for (int x = 0; x < 8; x++)
                {
                    int column = Math.Min(left + x, lastColumn);
                    int sample;
                    if (source.Format == PixelFormat.Nv12)
                        sample = row[2 * column + component - 1];
                    else if (source.Format == PixelFormat.Yuy2)
                        sample = row[4 * column + 2 * component - 1];
                    else
                        sample = ChromaOfPair(row + 8 * column, 2 * column + 1 < source.Width ? 4 : 0, component);
                    block[y * 8 + x] = sample - 128;
                }
            }
        }

        /// <summary>Chroma of the mean of two neighbouring pixels.</summary>
        private static int ChromaOfPair(byte* bgra, int next, int component)
        {
            int blue = bgra[0] + bgra[next];
            int green = bgra[1] + bgra[next + 1];
            int red = bgra[2] + bgra[next + 2];
            int sum = component == 1
                ? -11059 * red - 21709 * green + 32768 * blue
                : 32768 * red - 27439 * green - 5329 * blue;
            // Just under a half rounds pure blue and red to 255 rather than 256.
            return ((sum >> 1) + (128 << 16) + 32767) >> 16;
        }
    }
}
