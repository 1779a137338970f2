using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// How often each level occurs on a sparse grid of the working picture: of the pixels' change since the last frame, or of what they
    /// have been. A band is a share of the grid's rows; what bands count is added up afterwards.
    /// </summary>
    internal unsafe struct HistogramBands : IKernelBands
    {
        public const int Levels = 256;

        public FrameView View;

        /// <summary>Of the darkest channel's change, and not of the brightest channel's past.</summary>
        public bool IsOfChange;

        /// <summary>From sample to sample, working px; the first lies half of it from the border.</summary>
        public int Step;
        public int BandCount;

        /// <summary><see cref="Levels"/> for each band.</summary>
        public int* Histograms;

        public void Execute(int band)
        {
            // Two lists in turn: the commonest level comes many times in a row.
            int* histogram = Histograms + Levels * band, counts = stackalloc int[2 * Levels];
            for (int i = 0; i < 2 * Levels; i++)
                counts[i] = 0;
            int rows = (View.Height - Step / 2 + Step - 1) / Step;
            int first = (int)((long)rows * band / BandCount), end = (int)((long)rows * (band + 1) / BandCount);
            for (int row = first; row < end; row++)
            {
                if (IsOfChange)
                    CountChange(Step / 2 + row * Step, counts);
                else
                    CountPast(Step / 2 + row * Step, counts);
            }

            for (int i = 0; i < Levels; i++)
                histogram[i] = counts[i] + counts[Levels + i];
        }

        private void CountChange(int y, int* counts)
        {
            // In variables: what is written through a pointer could be this very structure.
            FrameView view = View;
            int step = Step, list = 0;
            for (int x = step / 2; x < view.Width; x += step, list ^= Levels)
            {
                int change = view.Change(y * view.Width + x, DetectionPlane.Smallest);
                counts[list + (change < 0 ? -change : change)]++;
            }
        }

        private void CountPast(int y, int* counts)
        {
            byte* row = View.OldLargest + (long)y * View.Width;
            int width = View.Width, step = Step, list = 0;
            for (int x = step / 2; x < width; x += step, list ^= Levels)
                counts[list + row[x]]++;
        }
    }
}
