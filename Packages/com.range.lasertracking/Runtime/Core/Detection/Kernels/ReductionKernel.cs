using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Raw picture → working picture of blue, green, red, (any) bytes, either at full size or at half size by the maximum of each
    /// channel over 2×2 pixels: a dot of one pixel survives, and nothing is averaged away. One row of the result a call; odd sizes
    /// repeat the last column or row. YUV is full-range BT.601. Scalar form here, vectors in the other part; equal to the bit.
    /// </summary>
    internal static unsafe partial class ReductionKernel
    {
        /// <summary>Pixels or 2×2 blocks along one side.</summary>
        public static int ReducedSize(int size, int factor) => (size + factor - 1) / factor;

        /// <summary>Writes row y of the working picture. The factor is 1 or 2.</summary>
        public static void Row(in PictureView image, int y, int factor, uint* target, bool useVectors)
        {
            int width = image.Width;
            int y0 = y * factor;
            int y1 = factor == 2 && y0 + 1 < image.Height ? y0 + 1 : y0;
            byte* row0 = image.Row(y0);
            byte* row1 = image.Row(y1);
            int done = 0;
            switch (image.Format)
            {
                case PixelFormat.Bgra32:
                    if (factor == 1)
                    {
                        PixelMemory.Copy((uint*)row0, target, width);
                        return;
                    }

#if NET8_0_OR_GREATER
                    if (useVectors)
                        done = HalveBgraVector((uint*)row0, (uint*)row1, width, target);
#endif
                    HalveBgra((uint*)row0, (uint*)row1, width, done, target);
                    break;
                case PixelFormat.Nv12:
                    byte* chroma = image.ChromaRow(y0);
                    if (factor == 1)
                    {
                        Nv12(row0, chroma, width, target);
                        break;
                    }

#if NET8_0_OR_GREATER
                    if (useVectors)
                        done = HalveNv12Vector(row0, row1, chroma, width, target);
#endif
                    HalveNv12(row0, row1, chroma, width, done, target);
                    break;
                case PixelFormat.Yuy2:
                    if (factor == 1)
                        Yuy2(row0, width, target);
                    else
                    {
#if NET8_0_OR_GREATER
                        if (useVectors)
                            done = HalveYuy2Vector(row0, row1, width, target);
#endif
                        HalveYuy2(row0, row1, width, done, target);
                    }

                    break;
                default:
                    if (factor == 1)
                        Gray(row0, width, target);
                    else
                        HalveGray(row0, row1, width, target);
                    break;
            }
        }

        private static void HalveBgra(uint* row0, uint* row1, int width, int start, uint* target)
        {
            int half = ReducedSize(width, 2);
            for (int x = start; x < half; x++)
            {
                int right = 2 * x + 1 < width ? 2 * x + 1 : 2 * x;
                target[x] = Max(Max(row0[2 * x], row1[2 * x]), Max(row0[right], row1[right]));
            }
        }

        private static uint Max(uint a, uint b)
        {
            uint blue = (a & 0xFFu) > (b & 0xFFu) ? a & 0xFFu : b & 0xFFu;
            uint green = (a & 0xFF00u) > (b & 0xFF00u) ? a & 0xFF00u : b & 0xFF00u;
            uint red = (a & 0xFF0000u) > (b & 0xFF0000u) ? a & 0xFF0000u : b & 0xFF0000u;
            uint alpha = (a & 0xFF000000u) > (b & 0xFF000000u) ? a & 0xFF000000u : b & 0xFF000000u;
            return blue | green | red | alpha;
        }

        private static void Nv12(byte* luma, byte* chroma, int width, uint* target)
        {
            for (int x = 0; x < width; x += 2)
            {
                int u = chroma[x], v = chroma[x + 1];
                int blue = PixelRow.BlueOffset(u), green = PixelRow.GreenOffset(u, v), red = PixelRow.RedOffset(v);
                target[x] = PixelRow.Pack(luma[x] + blue, luma[x] + green, luma[x] + red);
                target[x + 1] = PixelRow.Pack(luma[x + 1] + blue, luma[x + 1] + green, luma[x + 1] + red);
            }
        }

        private static void HalveNv12(byte* row0, byte* row1, byte* chroma, int width, int start, uint* target)
        {
            for (int x = start; x < width / 2; x++)
            {
                int a = row0[2 * x] > row0[2 * x + 1] ? row0[2 * x] : row0[2 * x + 1];
                int b = row1[2 * x] > row1[2 * x + 1] ? row1[2 * x] : row1[2 * x + 1];
                target[x] = PixelRow.FromYuv(a > b ? a : b, chroma[2 * x], chroma[2 * x + 1]);
            }
        }

        private static void Yuy2(byte* row, int width, uint* target)
        {
            for (int x = 0; x < width; x += 2, row += 4)
            {
                target[x] = PixelRow.FromYuv(row[0], row[1], row[3]);
                target[x + 1] = PixelRow.FromYuv(row[2], row[1], row[3]);
            }
        }

        private static void HalveYuy2(byte* row0, byte* row1, int width, int start, uint* target)
        {
            row0 += 4 * start;
            row1 += 4 * start;
            for (int x = start; x < width / 2; x++, row0 += 4, row1 += 4)
            {
                uint a = PixelRow.FromYuv(row0[0] > row0[2] ? row0[0] : row0[2], row0[1], row0[3]);
                uint b = PixelRow.FromYuv(row1[0] > row1[2] ? row1[0] : row1[2], row1[1], row1[3]);
                target[x] = Max(a, b);
            }
        }

        private static void Gray(byte* row, int width, uint* target)
        {
            for (int x = 0; x < width; x++)
                target[x] = row[x] * 0x010101u | 0xFF000000u;
        }

        private static void HalveGray(byte* row0, byte* row1, int width, uint* target)
        {
            int half = ReducedSize(width, 2);
            for (int x = 0; x < half; x++)
            {
                int right = 2 * x + 1 < width ? 2 * x + 1 : 2 * x;
                byte a = row0[2 * x] > row0[right] ? row0[2 * x] : row0[right];
                byte b = row1[2 * x] > row1[right] ? row1[2 * x] : row1[right];
                target[x] = (a > b ? a : b) * 0x010101u | 0xFF000000u;
            }
        }
    }
}
