using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The memory of the default detector: two working pictures, the envelopes before and after, the tiles. One pass over the raw
    /// frame fills them, each byte read once.
    /// </summary>
    internal sealed unsafe class DetectionPlanes
    {
        private readonly uint[][] _pictures = { Array.Empty<uint>(), Array.Empty<uint>() };
        private readonly byte[][] _smallest = { Array.Empty<byte>(), Array.Empty<byte>() };
        private readonly byte[][] _largest = { Array.Empty<byte>(), Array.Empty<byte>() };
        private byte[] _columns = Array.Empty<byte>();
        private uint[] _rows = Array.Empty<uint>();
        private int _sourceWidth;
        private int _sourceHeight;
        private PixelFormat _format;
        private int _turn;

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Source pixels per working pixel along a side.</summary>
        public int Factor { get; private set; } = 1;

        /// <summary>Frames taken in since the start.</summary>
        public long FrameCount { get; private set; }

        public TileGrid SmallestTiles { get; } = new TileGrid();

        public TileGrid LargestTiles { get; } = new TileGrid();

        public uint[] Now => _pictures[_turn];

        public uint[] Before => _pictures[1 - _turn];

        public byte[] OldSmallest => _smallest[1 - _turn];

        public byte[] NewSmallest => _smallest[_turn];

        public byte[] OldLargest => _largest[1 - _turn];

        public byte[] NewLargest => _largest[_turn];

        public void Reset() => _sourceWidth = 0;

        /// <summary>Makes room for frames like this one. True when it differs from the last one: everything known is forgotten.</summary>
        public bool Fit(Image image, int fullSizeMaxWidth)
        {
            if (image.Width == _sourceWidth && image.Height == _sourceHeight && image.Format == _format)
                return false;
            _sourceWidth = image.Width;
            _sourceHeight = image.Height;
            _format = image.Format;
            Factor = image.Width > fullSizeMaxWidth ? 2 : 1;
            Width = ReductionKernel.ReducedSize(image.Width, Factor);
            Height = ReductionKernel.ReducedSize(image.Height, Factor);
            for (int i = 0; i < 2; i++)
            {
                _pictures[i] = new uint[Width * Height];
                _smallest[i] = new byte[Width * Height];
                _largest[i] = new byte[Width * Height];
            }

            _columns = new byte[2 * Width];
            _rows = new uint[4 * Width];
            SmallestTiles.Resize(Width, Height);
            LargestTiles.Resize(Width, Height);
            FrameCount = 0;
            return true;
        }

        /// <summary>Takes a frame in, smoothed if it is that noisy. The first one only fills the past.</summary>
        public void Update(Image image, int decay, bool smooth, bool useVectors)
        {
            _turn = 1 - _turn;
            fixed (uint* picture = Now)
            fixed (uint* rows = _rows)
            fixed (byte* oldMin = OldSmallest, newMin = NewSmallest, oldMax = OldLargest, newMax = NewLargest, columns = _columns)
            {
                for (int top = 0; top < Height; top += TileGrid.Size)
                {
                    Array.Clear(_columns, 0, _columns.Length);
                    int bottom = Math.Min(Height, top + TileGrid.Size);
                    for (int y = top; y < bottom; y++)
                    {
                        long row = (long)y * Width;
                        if (smooth)
                            SmoothRow(image, y, rows, picture + row, useVectors);
                        else
                            ReductionKernel.Row(image, y, Factor, picture + row, useVectors);
                        EnvelopeKernel.Row(picture + row, Width, (byte)decay, oldMin + row, newMin + row, oldMax + row, newMax + row, columns, columns + Width, useVectors);
                    }

                    SmallestTiles.SetRow(top / TileGrid.Size, columns, Width);
                    LargestTiles.SetRow(top / TileGrid.Size, columns + Width, Width);
                }
            }

            FrameCount++;
        }

        /// <summary>Keeps the last three reduced and horizontally smoothed rows; the fourth holds the one being reduced.</summary>
        private void SmoothRow(Image image, int y, uint* rows, uint* target, bool useVectors)
        {
            for (int next = y == 0 ? 0 : y + 1; next <= Math.Min(y + 1, Height - 1); next++)
            {
                ReductionKernel.Row(image, next, Factor, rows + 3 * Width, useVectors);
                SmoothingKernel.Horizontal(rows + 3 * Width, Width, rows + next % 3 * Width, useVectors);
            }

            uint* above = rows + Math.Max(0, y - 1) % 3 * Width;
            uint* below = rows + Math.Min(Height - 1, y + 1) % 3 * Width;
            SmoothingKernel.Vertical(above, rows + y % 3 * Width, below, Width, target, useVectors);
        }
    }
}
