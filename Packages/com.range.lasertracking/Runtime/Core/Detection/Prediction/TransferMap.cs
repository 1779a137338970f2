using System;

namespace LaserTracking.Detection
{
    /// <summary>Gain (128 = 1) and offset (128 = 0) of every pixel of the rendered pictures, from those of the cells; renewed in turns.</summary>
    internal sealed unsafe class TransferMap
    {
        /// <summary>The whole picture is renewed over so many frames.</summary>
        private const int Turns = 24;

        private double[] _places = Array.Empty<double>();
        private int _width;
        private int _row;
        private bool _isFilled;

        /// <summary>Blue, green, red, 0.</summary>
        public uint[] Gain { get; private set; } = Array.Empty<uint>();

        /// <summary>Blue, green, red, 0.</summary>
        public uint[] Offset { get; private set; } = Array.Empty<uint>();

        public void Resize(int width, int height)
        {
            _width = width;
            _row = 0;
            _isFilled = false;
            Gain = new uint[width * height];
            Offset = new uint[width * height];
            _places = new double[height];
            for (int y = 0; y < height; y++)
                _places[y] = CellBlend.Place(y, height, ScreenGrid.Rows);
        }

        /// <summary>Renews some rows, the first time all; offsets are raised by the slack.</summary>
        public void Update(ColorTransfer transfer, int slack, bool useVectors)
        {
            int height = _places.Length, count = _isFilled ? (height + Turns - 1) / Turns : height;
            int first = (_row + 1) % height, whole = Math.Min(count, height - first);
            Fill(transfer, first, whole, slack, useVectors);
            Fill(transfer, 0, count - whole, slack, useVectors);
            _row = (_row + count) % height;
            _isFilled = true;
        }

        private void Fill(ColorTransfer transfer, int first, int count, int slack, bool useVectors)
        {
            fixed (double* gains = transfer.Gains, offsets = transfer.Offsets, places = _places)
            fixed (uint* gain = Gain, offset = Offset)
            {
                int start = first * _width;
                for (int x = 0; x < _width; x++)
                {
                    double column = CellBlend.Place(x, _width, ScreenGrid.Columns);
                    CellBlend.Column(gains, column, places + first, count, 128, 0, gain + start + x, _width, useVectors);
                    CellBlend.Column(offsets, column, places + first, count, 1, 128 + slack, offset + start + x, _width, useVectors);
                }
            }
        }
    }
}
