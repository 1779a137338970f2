using System;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>The mean of successive frames in which the projector showed the same.</summary>
    internal sealed unsafe class HeldPicture
    {
        private float[] _sum = Array.Empty<float>();

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Frames that went into it.</summary>
        public int Frames { get; private set; }

        public void Begin(Image image)
        {
            Width = image.Width;
            Height = image.Height;
            if (_sum.Length != Width * Height)
                _sum = new float[Width * Height];
            Array.Clear(_sum, 0, _sum.Length);
            Frames = 0;
            Add(image);
        }

        public void Add(Image image)
        {
            Frames++;
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1;
            for (int y = 0; y < Height; y++)
            {
                byte* pixel = image.Pixels + (long)y * image.Stride;
                Span<float> row = _sum.AsSpan(y * Width, Width);
                if (step == 4)
                {
                    for (int x = 0; x < row.Length; x++, pixel += 4)
                        row[x] += (29 * pixel[0] + 150 * pixel[1] + 77 * pixel[2]) * (1f / 256);
                }
                else
                {
                    for (int x = 0; x < row.Length; x++, pixel += step)
                        row[x] += *pixel;
                }
            }
        }

        /// <summary>Half of this one's brightness minus the other's, levels; either has Width × Height.</summary>
        public void Subtract(HeldPicture other, float[] difference)
        {
            float here = 0.5f / Frames, there = 0.5f / other.Frames;
            for (int i = 0; i < _sum.Length; i++)
                difference[i] = _sum[i] * here - other._sum[i] * there;
        }

        /// <summary>Brightness less the mean of a wide neighbourhood, levels: black and white of an even pattern on either side of zero.</summary>
        public void Flatten(float[] difference)
        {
            // Sums of the rows near this one by column, then of the columns up to each: exact, for levels are multiples of 1/256.
            int reach = Math.Max(4, Width / 20);
            double[] columns = new double[Width], upTo = new double[Width + 1];
            for (int y = 0; y < Math.Min(reach, Height); y++)
                AddRow(columns, y, 1);
            for (int y = 0; y < Height; y++)
            {
                if (y + reach < Height)
                    AddRow(columns, y + reach, 1);
                if (y - reach - 1 >= 0)
                    AddRow(columns, y - reach - 1, -1);
                for (int x = 0; x < Width; x++)
                    upTo[x + 1] = upTo[x] + columns[x];
                int rows = Math.Min(Height, y + reach + 1) - Math.Max(0, y - reach);
                for (int x = 0; x < Width; x++)
                {
                    int left = Math.Max(0, x - reach), right = Math.Min(Width, x + reach + 1);
                    double mean = (upTo[right] - upTo[left]) / ((right - left) * (double)rows);
                    difference[y * Width + x] = (float)((_sum[y * Width + x] - mean) / Frames);
                }
            }
        }

        private void AddRow(double[] columns, int y, int sign)
        {
            ReadOnlySpan<float> row = _sum.AsSpan(y * Width, Width);
            for (int x = 0; x < row.Length; x++)
                columns[x] += sign * row[x];
        }
    }
}
