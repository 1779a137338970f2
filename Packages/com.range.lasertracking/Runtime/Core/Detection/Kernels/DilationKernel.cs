namespace LaserTracking.Detection
{
    /// <summary>Largest byte of each pixel and its eight neighbours; the border repeats. One row a call. Scalar: runs only while the camera shakes.</summary>
    internal static unsafe class DilationKernel
    {
        /// <param name="above">Row above, or the row itself at the border.</param>
        /// <param name="row">The row.</param>
        /// <param name="below">Row below, or the row itself at the border.</param>
        /// <param name="width">Bytes in a row, at least 1.</param>
        /// <param name="target">Not one of the three.</param>
        public static void Row(byte* above, byte* row, byte* below, int width, byte* target)
        {
            int last = Column(above, row, below, 0), here = last;
            for (int x = 0; x < width; x++)
            {
                int next = x + 1 < width ? Column(above, row, below, x + 1) : here;
                int largest = last > here ? last : here;
                target[x] = (byte)(next > largest ? next : largest);
                last = here;
                here = next;
            }
        }

        private static int Column(byte* above, byte* row, byte* below, int x)
        {
            int largest = above[x] > row[x] ? above[x] : row[x];
            return below[x] > largest ? below[x] : largest;
        }
    }
}
