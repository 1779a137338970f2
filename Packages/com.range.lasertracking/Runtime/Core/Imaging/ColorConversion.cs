namespace LaserTracking.Imaging
{
    public static unsafe class ColorConversion
    {
        // ITU-R BT.601 with full range as JFIF has it, times 2^16.
        private const int RedFromV = 91881;
        private const int GreenFromU = -22554;
        private const int GreenFromV = -46802;
        private const int BlueFromU = 116130;
        private const int Half = 1 << 15;

        internal static void YuvToBgra(int luma, int u, int v, byte* bgra)
        {
            u -= 128;
            v -= 128;
            bgra[0] = Clamp(luma + ((BlueFromU * u + Half) >> 16));
            bgra[1] = Clamp(luma + ((GreenFromU * u + GreenFromV * v + Half) >> 16));
            bgra[2] = Clamp(luma + ((RedFromV * v + Half) >> 16));
            bgra[3] = 255;
        }

        private static byte Clamp(int value) => (byte)(value < 0 ? 0 : value > 255 ? 255 : value);
    }
}
