using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// One pass over a raw frame: working picture, envelopes, onsets of the tiles. A band is a share of the rows of tiles; bands write
    /// to different places and read no other band's, so they may run in any order or at once.
    /// </summary>
    internal unsafe struct PlaneBands : IKernelBands
    {
        /// <summary>Rows of scratch: the last three smoothed ones, one that is being reduced, one to shift from.</summary>
        public const int RowsPerBand = 5;

        /// <summary>Bytes of scratch for a column: onsets of both channels, and as many that nobody reads.</summary>
        public const int ColumnsPerPixel = 4;

        public PictureView Source;
        public int Width;
        public int Height;
        public int Factor;
        public int ShiftX;
        public int ShiftY;
        public byte Decay;
        public bool IsSmooth;
        public bool IsDilated;
        public bool UseVectors;
        public int BandCount;
        public uint* Picture;
        public byte* OldSmallest;
        public byte* NewSmallest;
        public byte* OldLargest;
        public byte* NewLargest;
        public byte* DilatedSmallest;
        public byte* DilatedLargest;
        public byte* SmallestOnsets;
        public byte* LargestOnsets;

        /// <summary>Scratch, <see cref="RowsPerBand"/> × width for each band.</summary>
        public uint* Rows;

        /// <summary>Scratch, <see cref="ColumnsPerPixel"/> × width for each band.</summary>
        public byte* Columns;

        public void Execute(int band)
        {
            int tileRows = TileGrid.Count(Height), first = (int)((long)tileRows * band / BandCount), end = (int)((long)tileRows * (band + 1) / BandCount);
            uint* rows = Rows + (long)band * RowsPerBand * Width;
            byte* columns = Columns + (long)band * ColumnsPerPixel * Width;
            int firstRow = first * TileGrid.Size;
            for (int tileRow = first; tileRow < end; tileRow++)
            {
                PixelMemory.Clear(columns, ColumnsPerPixel * Width);
                int bottom = (tileRow + 1) * TileGrid.Size < Height ? (tileRow + 1) * TileGrid.Size : Height;
                for (int y = tileRow * TileGrid.Size; y < bottom; y++)
                    TakeRow(y, y == firstRow, rows, columns);
                long tiles = (long)tileRow * TileGrid.Count(Width);
                TileGrid.ReduceRow(columns, Width, SmallestOnsets + tiles);
                TileGrid.ReduceRow(columns + Width, Width, LargestOnsets + tiles);
            }
        }

        private void TakeRow(int y, bool isFirst, uint* rows, byte* columns)
        {
            long row = (long)y * Width;
            uint* picture = Picture + row;
            if (IsSmooth)
                SmoothRow(y, isFirst, rows, picture);
            else
                ReduceRow(y, picture, rows);
            byte* onsets = columns;
            if (IsDilated)
            {
                // The onsets from the dilated past, the new past from the true one: it would grow by a pixel a frame.
                EnvelopeKernel.Row(picture, Width, Decay, DilatedSmallest + row, NewSmallest + row, DilatedLargest + row, NewLargest + row, columns, columns + Width, UseVectors);
                onsets += 2 * Width;
            }

            EnvelopeKernel.Row(picture, Width, Decay, OldSmallest + row, NewSmallest + row, OldLargest + row, NewLargest + row, onsets, onsets + Width, UseVectors);
        }

        /// <summary>Keeps the last three reduced and horizontally smoothed rows; a band's first row needs the one above it too.</summary>
        private void SmoothRow(int y, bool isFirst, uint* rows, uint* target)
        {
            int above = y > 0 ? y - 1 : 0, below = y + 1 < Height ? y + 1 : Height - 1;
            for (int next = isFirst ? above : y + 1; next <= below; next++)
            {
                ReduceRow(next, rows + 3 * Width, rows + 4 * Width);
                SmoothingKernel.Horizontal(rows + 3 * Width, Width, rows + next % 3 * Width, UseVectors);
            }

            SmoothingKernel.Vertical(rows + above % 3 * Width, rows + y % 3 * Width, rows + below % 3 * Width, Width, target, UseVectors);
        }

        /// <summary>One row of the working picture, put back by the displacement; spare has room for a row.</summary>
        private void ReduceRow(int y, uint* target, uint* spare)
        {
            int from = Within(y + ShiftY, Height);
            if (ShiftX == 0)
            {
                ReductionKernel.Row(Source, from, Factor, target, UseVectors);
                return;
            }

            ReductionKernel.Row(Source, from, Factor, spare, UseVectors);
            for (int x = 0; x < Width; x++)
                target[x] = spare[Within(x + ShiftX, Width)];
        }

        private static int Within(int place, int count) => place < 0 ? 0 : place < count ? place : count - 1;
    }
}
