using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The memory of the default detector: two working pictures, the envelopes before and after, the tiles. One pass over the raw
    /// frame fills them, each byte read once.
    /// </summary>
    internal sealed unsafe class DetectionPlanes
    {
        /// <summary>Levels from which a pixel may be brighter than it shows.</summary>
        public const int ClippedFrom = 250;

        private readonly KernelRunner _kernels;
        private readonly uint[][] _pictures = { Array.Empty<uint>(), Array.Empty<uint>() };
        private readonly byte[][] _smallest = { Array.Empty<byte>(), Array.Empty<byte>() };
        private readonly byte[][] _largest = { Array.Empty<byte>(), Array.Empty<byte>() };
        private byte[] _columns = Array.Empty<byte>();
        private uint[] _rows = Array.Empty<uint>();
        private int _sourceWidth;
        private int _sourceHeight;
        private PixelFormat _format;
        private int _turn;
        private int _bandCount;
        private byte[] _dilatedSmallest = Array.Empty<byte>();
        private byte[] _dilatedLargest = Array.Empty<byte>();
        private bool _isDilated;

        public DetectionPlanes(KernelRunner kernels) => _kernels = kernels;

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Source pixels per working pixel along a side.</summary>
        public int Factor { get; private set; } = 1;

        /// <summary>The full picture's.</summary>
        public PixelFormat Format => _format;

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
            _bandCount = Math.Min(_kernels.BandCount, TileGrid.Count(Height));
            _columns = new byte[PlaneBands.ColumnsPerPixel * Width * _bandCount];
            _rows = new uint[PlaneBands.RowsPerBand * Width * _bandCount];
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
            fixed (uint* picture = Now)
            fixed (byte* smallest = NewSmallest, largest = NewLargest)
            {
                var work = new RescaleBands { Width = Width, Table = table, Smallest = smallest, Largest = largest, Picture = picture };
                _kernels.Run(&work, Height);
            }
        }

        /// <summary>
        /// Takes a frame in, smoothed if it is that noisy. The first one only fills the past. A displaced picture is put back to where
        /// it used to be; what the displacement leaves empty repeats the border.
        /// </summary>
        public void Update(Image image, GlobalChangeMeter change, int decay, bool smooth, bool useVectors)
        {
            if (change.Gain != 1)
                Rescale(change.Gain);
            _turn = 1 - _turn;
            _isDilated = change.IsBetweenPixels;
            if (_isDilated)
            {
                Dilate(_smallest[1 - _turn], _dilatedSmallest);
                Dilate(_largest[1 - _turn], _dilatedLargest);
            }

            fixed (uint* picture = Now, rows = _rows)
            fixed (byte* oldMin = _smallest[1 - _turn], newMin = NewSmallest, oldMax = _largest[1 - _turn], newMax = NewLargest, columns = _columns)
            fixed (byte* dilatedMin = _dilatedSmallest, dilatedMax = _dilatedLargest, smallest = SmallestTiles.Onsets, largest = LargestTiles.Onsets)
            {
                var work = new PlaneBands
                {
                    Source = image,
                    Width = Width,
                    Height = Height,
                    Factor = Factor,
                    ShiftX = change.ShiftX,
                    ShiftY = change.ShiftY,
                    Decay = (byte)decay,
                    IsSmooth = smooth,
                    IsDilated = _isDilated,
                    UseVectors = useVectors,
                    BandCount = _bandCount,
                    Picture = picture,
                    OldSmallest = oldMin,
                    NewSmallest = newMin,
                    OldLargest = oldMax,
                    NewLargest = newMax,
                    DilatedSmallest = dilatedMin,
                    DilatedLargest = dilatedMax,
                    SmallestOnsets = smallest,
                    LargestOnsets = largest,
                    Rows = rows,
                    Columns = columns,
                };
                _kernels.Run(&work, _bandCount);
            }

            FrameCount++;
        }

        private void Dilate(byte[] source, byte[] target)
        {
            fixed (byte* from = source, to = target)
            {
                var work = new DilationBands { Source = from, Target = to, Width = Width, Height = Height };
                _kernels.Run(&work, Height);
            }
        }
    }
}
