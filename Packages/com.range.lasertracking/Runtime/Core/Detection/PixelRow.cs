using LaserTracking.Imaging;
#if NET8_0_OR_GREATER
using System.Numerics;
#endif

namespace LaserTracking.Detection
{
    /// <summary>Part of a row of any raw picture as blue, green, red, 255: for exact work on few pixels. Full-range BT.601.</summary>
    internal static unsafe class PixelRow
    {
        /// <summary>What chroma adds to luma: 6-bit fixed point, the same in every kernel so that all agree to the bit.</summary>
        public static int BlueOffset(int u) => (113 * (u - 128) + 32) >> 6;

        public static int GreenOffset(int u, int v) => (-22 * (u - 128) - 46 * (v - 128) + 32) >> 6;

        public static int RedOffset(int v) => (90 * (v - 128) + 32) >> 6;

        public static bool CanRead(PixelFormat format) =>
            format == PixelFormat.Bgra32 || format == PixelFormat.Nv12 || format == PixelFormat.Yuy2 || format == PixelFormat.Gray8;

        /// <summary>Pixels x0 … x1-1 of row y into target, which has room for them. The caller keeps to the picture.</summary>
        public static void ToBgra(Image image, int y, int x0, int x1, uint* target)
        {
            byte* row = image.Pixels + (long)y * image.Stride;
            switch (image.Format)
            {
                case PixelFormat.Bgra32:
                    Opaque((uint*)row + x0, x1 - x0, target);
                    break;
                case PixelFormat.Nv12:
                    byte* chroma = image.Pixels + (long)image.Height * image.Stride + (long)(y >> 1) * image.Stride;
                    for (int x = x0; x < x1; x++)
                        *target++ = FromYuv(row[x], chroma[x & ~1], chroma[x | 1]);
                    break;
                case PixelFormat.Yuy2:
                    for (int x = x0; x < x1; x++)
                        *target++ = FromYuv(row[2 * x], row[4 * (x >> 1) + 1], row[4 * (x >> 1) + 3]);
                    break;
                default:
                    for (int x = x0; x < x1; x++)
                        *target++ = row[x] * 0x010101u | 0xFF000000u;
                    break;
            }
        }

        /// <summary>Brightness of one pixel: luma as it is stored, or that of the colours.</summary>
        public static int Luma(Image image, int y, int x)
        {
            byte* row = image.Pixels + (long)y * image.Stride;
            if (image.Format == PixelFormat.Bgra32)
                return (29 * row[4 * x] + 150 * row[4 * x + 1] + 77 * row[4 * x + 2] + 128) >> 8;
            return image.Format == PixelFormat.Yuy2 ? row[2 * x] : row[x];
        }

        public static uint FromYuv(int y, int u, int v) =>
            Pack(y + BlueOffset(u), y + GreenOffset(u, v), y + RedOffset(v));

        public static uint Pack(int blue, int green, int red) =>
            Clamp(blue) | Clamp(green) << 8 | Clamp(red) << 16 | 0xFF000000u;

        private static void Opaque(uint* source, int count, uint* target)
        {
            const uint Alpha = 0xFF000000u;
            int i = 0;
#if NET8_0_OR_GREATER
            for (; i + Vector<uint>.Count <= count; i += Vector<uint>.Count)
                Vector.Store(Vector.Load(source + i) | new Vector<uint>(Alpha), target + i);
#endif
            for (; i < count; i++)
                target[i] = source[i] | Alpha;
        }

        private static uint Clamp(int value) => value < 0 ? 0u : value > 255 ? 255u : (uint)value;
    }
}
