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
        private const int ClippedFrom = 250;
        private readonly uint[][] _pictures = { Array.Empty<uint>(), Array.Empty<uint>() };
        private readonly byte[][] _smallest = { Array.Empty<byte>(), Array.Empty<byte>() };
        private readonly byte[][] _largest = { Array.Empty<byte>(), Array.Empty<byte>() };
        private byte[] _columns = Array.Empty<byte>();
        private uint[] _rows = Array.Empty<uint>();
        private int _sourceWidth;
        private int _sourceHeight;
        private PixelFormat _format;
        private int _turn;
        private int _shiftX;
        private int _shiftY;
        private byte[] _dilatedSmallest = Array.Empty<byte>();
        private byte[] _dilatedLargest = Array.Empty<byte>();
        private bool _isDilated;

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

        /// <summary>What the pixels' own past explains in this frame; while the camera shakes, with that of their neighbours.</summary>
        public byte[] OldSmallest => _isDilated ? _dilatedSmallest : _smallest[1 - _turn];

        public byte[] NewSmallest => _smallest[_turn];

        public byte[] OldLargest => _isDilated ? _dilatedLargest : _largest[1 - _turn];

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

            _dilatedSmallest = new byte[Width * Height];
            _dilatedLargest = new byte[Width * Height];
            _columns = new byte[4 * Width];
            _rows = new uint[5 * Width];
            SmallestTiles.Resize(Width, Height);
            LargestTiles.Resize(Width, Height);
            FrameCount = 0;
            return true;
        }

        /// <summary>Gives the past the brightness that a change of exposure has given the present. What was clipped may have been brighter: it stays.</summary>
        public void Rescale(double gain)
        {
            byte* table = stackalloc byte[256];
            for (int i = 0; i < 256; i++)
                table[i] = (byte)(i >= ClippedFrom && gain < 1 ? i : Math.Min(255, Math.Round(i * gain)));
            Replace(NewSmallest, table);
            Replace(NewLargest, table);
            fixed (uint* picture = Now)
            {
                byte* bytes = (byte*)picture;
                for (int i = 0; i < Width * Height * 4; i++)
                    bytes[i] = table[bytes[i]];
            }
        }

        private static void Replace(byte[] plane, byte* table)
        {
            for (int i = 0; i < plane.Length; i++)
                plane[i] = table[plane[i]];
        }

        /// <summary>
        /// Takes a frame in, smoothed if it is that noisy. The first one only fills the past. A displaced picture is put back to where
        /// it used to be; what the displacement leaves empty repeats the border.
        /// </summary>
        public void Update(Image image, GlobalChangeMeter change, int decay, bool smooth, bool useVectors)
        {
            if (change.Gain != 1)
                Rescale(change.Gain);
            _shiftX = change.ShiftX;
            _shiftY = change.ShiftY;
            _turn = 1 - _turn;
            _isDilated = change.IsBetweenPixels;
            if (_isDilated)
            {
                Dilate(_smallest[1 - _turn], _dilatedSmallest);
                Dilate(_largest[1 - _turn], _dilatedLargest);
            }

            fixed (uint* picture = Now)
            fixed (uint* rows = _rows)
            fixed (byte* oldMin = _smallest[1 - _turn], newMin = NewSmallest, oldMax = _largest[1 - _turn], newMax = NewLargest, columns = _columns)
            fixed (byte* dilatedMin = _dilatedSmallest, dilatedMax = _dilatedLargest)
            {
                byte* unused = columns + 2 * Width;
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
                            ReduceRow(image, y, picture + row, rows, useVectors);
                        // The onsets from the dilated past, the new past from the true one: it would grow by a pixel a frame.
                        if (_isDilated)
                            EnvelopeKernel.Row(picture + row, Width, (byte)decay, dilatedMin + row, newMin + row, dilatedMax + row, newMax + row, columns, columns + Width, useVectors);
                        byte* onsets = _isDilated ? unused : columns;
                        EnvelopeKernel.Row(picture + row, Width, (byte)decay, oldMin + row, newMin + row, oldMax + row, newMax + row, onsets, onsets + Width, useVectors);
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
                ReduceRow(image, next, rows + 3 * Width, rows + 4 * Width, useVectors);
                SmoothingKernel.Horizontal(rows + 3 * Width, Width, rows + next % 3 * Width, useVectors);
            }

            uint* above = rows + Math.Max(0, y - 1) % 3 * Width;
            uint* below = rows + Math.Min(Height - 1, y + 1) % 3 * Width;
            SmoothingKernel.Vertical(above, rows + y % 3 * Width, below, Width, target, useVectors);
        }

        private void Dilate(byte[] source, byte[] target)
        {
            fixed (byte* from = source, to = target)
            {
                for (int y = 0; y < Height; y++)
                    DilationKernel.Row(from + Math.Max(0, y - 1) * Width, from + y * Width, from + Math.Min(Height - 1, y + 1) * Width, Width, to + y * Width);
            }
        }

        /// <summary>One row of the working picture, put back by the displacement; spare has room for a row.</summary>
        private void ReduceRow(Image image, int y, uint* target, uint* spare, bool useVectors)
        {
            int from = Math.Max(0, Math.Min(Height - 1, y + _shiftY));
            if (_shiftX == 0)
            {
                ReductionKernel.Row(image, from, Factor, target, useVectors);
                return;
            }

            ReductionKernel.Row(image, from, Factor, spare, useVectors);
            for (int x = 0; x < Width; x++)
                target[x] = spare[Math.Max(0, Math.Min(Width - 1, x + _shiftX))];
        }
    }
}
