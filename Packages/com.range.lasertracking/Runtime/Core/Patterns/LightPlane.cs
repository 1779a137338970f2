using System;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>A picture of real numbers: brightness, or the difference of two. Its memory is kept when it is fitted anew.</summary>
    internal sealed class LightPlane
    {
        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Row by row without padding; may be longer than the picture.</summary>
        public float[] Values { get; private set; } = Array.Empty<float>();

        public void Fit(int width, int height)
        {
            Width = width;
            Height = height;
            if (Values.Length < width * height)
                Values = new float[width * height];
        }

        /// <summary>Adds a picture's brightness.</summary>
        public unsafe void Add(Image image)
        {
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1;
            for (int y = 0; y < Height; y++)
            {
                byte* pixel = image.Pixels + (long)y * image.Stride;
                Span<float> row = Values.AsSpan(y * Width, Width);
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

        public void SetToDifference(LightPlane first, float firstFactor, LightPlane second, float secondFactor)
        {
            Fit(first.Width, first.Height);
            for (int i = 0; i < Width * Height; i++)
                Values[i] = first.Values[i] * firstFactor - second.Values[i] * secondFactor;
        }

        /// <summary>Means over squares of the given side.</summary>
        public void SetToReduced(LightPlane source, int side)
        {
            Fit(source.Width / side, source.Height / side);
            float share = 1f / (side * side);
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                {
                    float sum = 0;
                    for (int j = 0; j < side; j++)
                    {
                        int from = (y * side + j) * source.Width + x * side;
                        for (int i = 0; i < side; i++)
                            sum += source.Values[from + i];
                    }

                    Values[y * Width + x] = sum * share;
                }
            }
        }

        /// <summary>A Gaussian blur of another plane; the border's values go on outside of it.</summary>
        public void SetToBlurred(LightPlane source, double sigma, LightPlane scratch)
        {
            Fit(source.Width, source.Height);
            scratch.Fit(source.Width, source.Height);
            int radius = (int)Math.Ceiling(3 * sigma);
            var kernel = new float[radius + 1];
            double sum = 0;
            for (int i = 0; i <= radius; i++)
                sum += (i == 0 ? 1 : 2) * Math.Exp(-i * i / (2 * sigma * sigma));
            for (int i = 0; i <= radius; i++)
                kernel[i] = (float)(Math.Exp(-i * i / (2 * sigma * sigma)) / sum);
            for (int y = 0; y < Height; y++)
            {
                Span<float> row = source.Values.AsSpan(y * Width, Width), target = scratch.Values.AsSpan(y * Width, Width);
                for (int x = 0; x < row.Length; x++)
                {
                    float value = row[x] * kernel[0];
                    if (x >= radius && x < row.Length - radius)
                    {
                        for (int i = 1; i <= radius; i++)
                            value += (row[x - i] + row[x + i]) * kernel[i];
                    }
                    else
                    {
                        for (int i = 1; i <= radius; i++)
                            value += (row[Math.Max(0, x - i)] + row[Math.Min(row.Length - 1, x + i)]) * kernel[i];
                    }

                    target[x] = value;
                }
            }

            for (int y = 0; y < Height; y++)
            {
                Span<float> target = Values.AsSpan(y * Width, Width);
                scratch.Values.AsSpan(y * Width, Width).CopyTo(target);
                for (int x = 0; x < target.Length; x++)
                    target[x] *= kernel[0];
                for (int i = 1; i <= radius; i++)
                {
                    Span<float> above = scratch.Values.AsSpan(Math.Max(0, y - i) * Width, Width), below = scratch.Values.AsSpan(Math.Min(Height - 1, y + i) * Width, Width);
                    for (int x = 0; x < target.Length; x++)
                        target[x] += (above[x] + below[x]) * kernel[i];
                }
            }
        }

        /// <summary>Between the pixels, bilinear; the border's values go on outside.</summary>
        public double At(double x, double y)
        {
            x = Math.Max(0, Math.Min(Width - 1.001, x));
            y = Math.Max(0, Math.Min(Height - 1.001, y));
            int left = (int)x, top = (int)y, at = top * Width + left;
            double dx = x - left, dy = y - top;
            double upper = Values[at] + (Values[at + 1] - Values[at]) * dx;
            double lower = Values[at + Width] + (Values[at + Width + 1] - Values[at + Width]) * dx;
            return upper + (lower - upper) * dy;
        }
    }
}
