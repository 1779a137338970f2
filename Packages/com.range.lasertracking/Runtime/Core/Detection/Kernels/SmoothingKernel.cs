namespace LaserTracking.Detection
{
    /// <summary>
    /// 3×3 smoothing by rounded averages of bytes, (1 2 1) both ways: takes noise of neighbouring pixels down to three eighths. Every
    /// average rounds up, which adds a constant that background and picture share. Scalar form here, vectors in the other part.
    /// </summary>
    internal static unsafe partial class SmoothingKernel
    {
        /// <summary>Along a row; the ends repeat. Source and target differ.</summary>
        public static void Horizontal(uint* source, int width, uint* target, bool useVectors)
        {
            target[0] = Weigh(source[0], source[0], source[width > 1 ? 1 : 0]);
            int x = 1;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = HorizontalVector(source, width, target);
#endif
            for (; x < width - 1; x++)
                target[x] = Weigh(source[x - 1], source[x], source[x + 1]);
            if (width > 1)
                target[width - 1] = Weigh(source[width - 2], source[width - 1], source[width - 1]);
        }

        /// <summary>Across three rows.</summary>
        public static void Vertical(uint* above, uint* row, uint* below, int width, uint* target, bool useVectors)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = VerticalVector(above, row, below, width, target);
#endif
            for (; x < width; x++)
                target[x] = Weigh(above[x], row[x], below[x]);
        }

        private static uint Weigh(uint left, uint center, uint right) => Average(Average(left, right), center);

        /// <summary>(a + b + 1) / 2 in each byte: a | b less half of what differs.</summary>
        private static uint Average(uint a, uint b) => (a | b) - (((a ^ b) & 0xFEFEFEFEu) >> 1);
    }
}
