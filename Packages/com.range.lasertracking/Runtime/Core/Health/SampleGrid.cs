using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>
    /// Some thousand pixels of the raw picture on a regular grid, those of this frame and of the one before: all that the checks of
    /// brightness, flicker and freezing look at.
    /// </summary>
    internal sealed unsafe class SampleGrid
    {
        public const int MostColumns = 40;
        public const int MostRows = 64;

        private byte[][] _now = Planes(0);
        private byte[][] _before = Planes(0);
        private int[] _x = Array.Empty<int>();
        private bool[] _isOnScreen = Array.Empty<bool>();
        private int _width;
        private int _height;
        private PixelFormat _format;

        public int Columns { get; private set; }

        public int Rows { get; private set; }

        public int Count => Columns * Rows;

        /// <summary>Frames read since the picture last changed its size or format.</summary>
        public int FrameCount { get; private set; }

        public byte[] Blue => _now[0];

        public byte[] Green => _now[1];

        public byte[] Red => _now[2];

        public byte[] GreenBefore => _before[1];

        /// <summary>By sample: it lies on the screen, or no screen is known.</summary>
        public bool[] IsOnScreen => _isOnScreen;

        /// <summary>Samples on the screen.</summary>
        public int ScreenCount { get; private set; }

        /// <summary>A channel of this frame: 0 blue, 1 green, 2 red.</summary>
        public byte[] Channel(int channel) => _now[channel];

        /// <summary>No sample differs from the frame before.</summary>
        public bool IsUnchanged
        {
            get
            {
                for (int c = 0; c < 3; c++)
                {
                    if (!_now[c].AsSpan().SequenceEqual(_before[c]))
                        return false;
                }

                return FrameCount > 1;
            }
        }

        public void Reset() => _width = 0;

        /// <summary>Reads a picture of a format that the detectors read.</summary>
        public void Read(Image image, ScreenMask screen)
        {
            if (image.Width != _width || image.Height != _height || image.Format != _format)
                Fit(image, screen);
            FrameCount++;
            (_now, _before) = (_before, _now);
            byte[] blue = _now[0], green = _now[1], red = _now[2];
            int i = 0;
            for (int row = 0; row < Rows; row++)
            {
                int y = (2 * row + 1) * _height / (2 * Rows);
                uint* bgra = image.Format == PixelFormat.Bgra32 ? (uint*)(image.Pixels + (long)y * image.Stride) : null;
                for (int column = 0; column < Columns; column++, i++)
                {
                    uint pixel;
                    if (bgra != null)
                        pixel = bgra[_x[column]];
                    else
                        PixelRow.ToBgra(image, y, _x[column], _x[column] + 1, &pixel);
                    blue[i] = (byte)pixel;
                    green[i] = (byte)(pixel >> 8);
                    red[i] = (byte)(pixel >> 16);
                }
            }
        }

        private static byte[][] Planes(int count) => new[] { new byte[count], new byte[count], new byte[count] };

        private void Fit(Image image, ScreenMask screen)
        {
            _width = image.Width;
            _height = image.Height;
            _format = image.Format;
            Columns = Math.Min(MostColumns, _width);
            Rows = Math.Min(MostRows, _height);
            _now = Planes(Count);
            _before = Planes(Count);
            _x = new int[Columns];
            for (int column = 0; column < Columns; column++)
                _x[column] = (2 * column + 1) * _width / (2 * Columns);
            _isOnScreen = new bool[Count];
            ScreenCount = 0;
            FrameCount = 0;
            for (int i = 0; i < Count; i++)
            {
                _isOnScreen[i] = screen.SignedDistancePx(new Vector2D(_x[i % Columns], (2 * (i / Columns) + 1) * _height / (2 * Rows))) <= 0;
                if (_isOnScreen[i])
                    ScreenCount++;
            }
        }
    }
}
