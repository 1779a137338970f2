namespace LaserTracking.Simulation
{
    /// <summary>BGRA rows to the camera's YUV formats: BT.601, full range, 16-bit fixed point.</summary>
    internal static unsafe class ColorPacking
    {
        /// <summary>Two rows to two rows of luma and one of interleaved chroma.</summary>
        public static void Nv12(byte* upper, byte* lower, int width, byte* lumaUpper, byte* lumaLower, byte* chroma)
        {
            for (int x = 0; x < width; x += 2)
            {
                byte* a = upper + 4 * x, b = lower + 4 * x;
                lumaUpper[x] = Luma(a);
                lumaUpper[x + 1] = Luma(a + 4);
                lumaLower[x] = Luma(b);
                lumaLower[x + 1] = Luma(b + 4);
                Chroma(a[0] + a[4] + b[0] + b[4], a[1] + a[5] + b[1] + b[5], a[2] + a[6] + b[2] + b[6], 2, out chroma[x], out chroma[x + 1]);
            }
        }

        public static void Yuy2(byte* row, int width, byte* packed)
        {
            for (int x = 0; x < width; x += 2)
            {
                byte* a = row + 4 * x, p = packed + 2 * x;
                p[0] = Luma(a);
                p[2] = Luma(a + 4);
                Chroma(a[0] + a[4], a[1] + a[5], a[2] + a[6], 1, out p[1], out p[3]);
            }
        }

        private static byte Luma(byte* bgra) => (byte)(7471 * bgra[0] + 38470 * bgra[1] + 19595 * bgra[2] + 32768 >> 16);

        // Sums of 2^shift pixels.
        private static void Chroma(int blue, int green, int red, int shift, out byte u, out byte v)
        {
            int half = 1 << 15 + shift, middle = 128 << 16 + shift;
            u = Clip(32768 * blue - 21709 * green - 11059 * red + middle + half >> 16 + shift);
            v = Clip(32768 * red - 27439 * green - 5329 * blue + middle + half >> 16 + shift);
        }

        private static byte Clip(int value) => (byte)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
}
