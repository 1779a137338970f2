using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>A picture that the projector was given, reduced to at most the history's width, with its looks at the grid of the screen.</summary>
    internal sealed unsafe class RenderedPicture
    {
        private readonly Image _image = new Image();
        private int[] _sums = Array.Empty<int>();
        private uint[] _row = Array.Empty<uint>();

        /// <summary>When it was drawn, microseconds.</summary>
        public long TimeUs { get; private set; }

        /// <summary>Blue, green, red, any; rows without padding. Valid until the next <see cref="Fill"/>.</summary>
        public uint* Pixels => (uint*)_image.Pixels;

        /// <summary>Brightness of each cell of the screen's grid; see <see cref="ScreenGrid"/>.</summary>
        public short[] Cells { get; } = new short[ScreenGrid.CellCount];

        /// <param name="source">Any format that <see cref="PixelRow"/> reads.</param>
        /// <param name="factor">Source pixels per pixel along a side: their mean is taken.</param>
        /// <param name="width">Of the reduced picture.</param>
        /// <param name="height">Of the reduced picture.</param>
        /// <param name="lookPixels">Where the grid looks, indices into the reduced picture.</param>
        /// <param name="timeUs">When it was drawn.</param>
        public void Fill(Image source, int factor, int width, int height, int[] lookPixels, long timeUs)
        {
            TimeUs = timeUs;
            _image.Reset(PixelFormat.Bgra32, width, height, timeUs);
            if (factor == 1)
            {
                for (int y = 0; y < height; y++)
                    PixelRow.ToBgra(source, y, 0, width, Pixels + (long)y * width);
            }
            else
            {
                Reduce(source, factor, width, height, Pixels);
            }

            fixed (short* cells = Cells)
            fixed (int* looks = lookPixels)
                ScreenGrid.SumCells(Pixels, looks, cells);
        }

        private void Reduce(Image source, int factor, int width, int height, uint* target)
        {
            if (_sums.Length != 3 * width || _row.Length != width * factor)
            {
                _sums = new int[3 * width];
                _row = new uint[width * factor];
            }

            int count = factor * factor, half = count / 2;
            fixed (uint* row = _row)
            fixed (int* sums = _sums)
            {
                for (int y = 0; y < height; y++)
                {
                    Array.Clear(_sums, 0, _sums.Length);
                    for (int inner = 0; inner < factor; inner++)
                    {
                        PixelRow.ToBgra(source, y * factor + inner, 0, width * factor, row);
                        for (int x = 0, i = 0; x < width; x++)
                        {
                            for (int j = 0; j < factor; j++, i++)
                            {
                                sums[3 * x] += (int)(row[i] & 255);
                                sums[3 * x + 1] += (int)(row[i] >> 8 & 255);
                                sums[3 * x + 2] += (int)(row[i] >> 16 & 255);
                            }
                        }
                    }

                    for (int x = 0; x < width; x++)
                        *target++ = (uint)((sums[3 * x] + half) / count) | (uint)((sums[3 * x + 1] + half) / count) << 8 | (uint)((sums[3 * x + 2] + half) / count) << 16 | 0xFF000000u;
                }
            }
        }
    }
}
