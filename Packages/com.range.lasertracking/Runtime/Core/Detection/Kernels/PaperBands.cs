using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The published algorithm's float pictures of one frame. A band is a share of the reduced rows; what it needs of its neighbours'
    /// rows it works out itself, into scratch, so bands may run in any order or at once.
    /// </summary>
    internal unsafe struct PaperBands : IKernelBands
    {
        /// <summary>Three blurred rows of the difference, three of the excess, one raw row of each; intensity and background of a row that is another band's.</summary>
        public const int RowsPerBand = 10;

        public PictureView Source;
        public int Width;
        public int Height;
        public bool HasBackground;
        public bool UseVectors;
        public int BandCount;
        public float Alpha;
        public float Gamma;
        public float SpikeWeight;
        public float ExcessWeight;
        public int* Edges;
        public float* Intensity;
        public float* Background;
        public float* NextBackground;
        public float* Excess;
        public float* Spike;
        public float* Score;

        /// <summary>Scratch, <see cref="RowsPerBand"/> × width for each band.</summary>
        public float* Rows;

        /// <summary>Scratch, <see cref="SourceRowsLength"/> for each band; unused for pictures that are BGRA already.</summary>
        public uint* SourceRows;

        public int SourceRowsLength;

        public void Execute(int band)
        {
            int first = (int)((long)Height * band / BandCount), end = (int)((long)Height * (band + 1) / BandCount);
            float* rows = Rows + (long)band * RowsPerBand * Width;
            uint* source = SourceRows + (long)band * SourceRowsLength;
            float* difference = rows + 6 * Width, excess = rows + 7 * Width;
            if (!HasBackground)
            {
                for (int y = first; y < end; y++)
                    Reduce(y, source, Intensity + (long)y * Width, excess);
                return;
            }

            int next = first > 0 ? first - 1 : 0;
            for (int y = first; y < end; y++)
            {
                for (; next <= y + 1 && next < Height; next++)
                {
                    bool isOwn = next >= first && next < end;
                    long row = (long)next * Width;
                    float* intensity = isOwn ? Intensity + row : rows + 8 * Width;
                    Reduce(next, source, intensity, excess);
                    PaperKernel.Differ(intensity, Background + row, isOwn ? NextBackground + row : rows + 9 * Width, Width, Alpha, difference, UseVectors);
                    PaperKernel.BlurRow(difference, Width, rows + next % 3 * Width, UseVectors);
                    PaperKernel.BlurRow(excess, Width, rows + (3 + next % 3) * Width, UseVectors);
                }

                Finish(y, rows);
            }
        }

        /// <summary>Area average over whole source pixels; writes intensity and the raw green excess.</summary>
        private void Reduce(int y, uint* converted, float* intensity, float* excess)
        {
            int top = (int)((long)y * Source.Height / Height), bottom = (int)((long)(y + 1) * Source.Height / Height);
            if (bottom <= top)
                bottom = top + 1;
            byte* source = Source.Row(top);
            long stride = Source.Stride;
            if (Source.Format != PixelFormat.Bgra32)
            {
                for (int row = top; row < bottom; row++)
                    ReductionKernel.Row(Source, row, 1, converted + (long)(row - top) * Source.Width, UseVectors);
                source = (byte*)converted;
                stride = 4L * Source.Width;
            }

            PaperKernel.Reduce(source, bottom - top, stride, Edges, Width, intensity, excess, UseVectors);
        }

        /// <summary>The second half of the 3×3 Gaussian (1 2 1) ⊗ (1 2 1) / 16, edges repeated; then spike map and score.</summary>
        private void Finish(int y, float* rows)
        {
            int above = (y > 0 ? y - 1 : 0) % 3 * Width, middle = y % 3 * Width, below = (y + 1 < Height ? y + 1 : Height - 1) % 3 * Width;
            long row = (long)y * Width;
            float* difference = rows + 6 * Width, blurred = rows + 3 * Width;
            PaperKernel.BlurColumns(rows + above, rows + middle, rows + below, Width, difference, UseVectors);
            PaperKernel.BlurColumns(blurred + above, blurred + middle, blurred + below, Width, Excess + row, UseVectors);
            PaperKernel.Score(difference, Excess + row, Spike + row, Width, Gamma, SpikeWeight, ExcessWeight, Score + row, UseVectors);
        }
    }
}
