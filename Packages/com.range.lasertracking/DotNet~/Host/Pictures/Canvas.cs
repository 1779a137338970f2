using System;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Pictures
{
    /// <summary>A picture to draw rectangles, lines, pixels and text on; what lies outside is left out. Colours are 0xRRGGBB.</summary>
    internal sealed unsafe class Canvas : IDisposable
    {
        public Canvas(int width, int height, uint background)
        {
            Image.Reset(PixelFormat.Bgra32, width, height, 0);
            Fill(0, 0, width, height, background);
        }

        public Image Image { get; } = new();

        public int Width => Image.Width;

        public int Height => Image.Height;

        public void Fill(int x, int y, int width, int height, uint color)
        {
            int x0 = Math.Max(0, x), x1 = Math.Min(Width, x + width), y0 = Math.Max(0, y), y1 = Math.Min(Height, y + height);
            for (int row = y0; row < y1; row++)
                new Span<uint>(Row(row) + x0, Math.Max(0, x1 - x0)).Fill(color | 0xFF000000u);
        }

        /// <summary>A frame around a rectangle, its lines inside.</summary>
        public void Outline(int x, int y, int width, int height, uint color, int thickness = 1)
        {
            Fill(x, y, width, thickness, color);
            Fill(x, y + height - thickness, width, thickness, color);
            Fill(x, y, thickness, height, color);
            Fill(x + width - thickness, y, thickness, height, color);
        }

        /// <summary>A straight line, one pixel wide or more; long or endless ones are cut at the picture.</summary>
        public void Line(double x0, double y0, double x1, double y1, uint color, int thickness = 1)
        {
            double length = Math.Max(Math.Abs(x1 - x0), Math.Abs(y1 - y0));
            int steps = (int)Math.Min(length, 4.0 * (Width + Height));
            for (int i = 0; i <= steps; i++)
            {
                double share = steps == 0 ? 0 : i / (double)steps;
                Fill((int)Math.Round(x0 + share * (x1 - x0)) - thickness / 2, (int)Math.Round(y0 + share * (y1 - y0)) - thickness / 2, thickness, thickness, color);
            }
        }

        /// <summary>Pixels of another picture, blue in the lowest byte, each a square of the given size.</summary>
        public void Magnify(ReadOnlySpan<uint> pixels, int side, int x, int y, int size)
        {
            for (int i = 0; i < pixels.Length; i++)
                Fill(x + i % side * size, y + i / side * size, size, size, pixels[i] & 0xFFFFFF);
        }

        /// <summary>A Bgra32 picture, each pixel a square (magnification ≥ 1) or the mean of several (reduction ≥ 1; one of both is 1).</summary>
        public void Draw(Image bgra, int x, int y, int magnification, int reduction)
        {
            for (int row = 0; row < bgra.Height / reduction; row++)
            {
                for (int column = 0; column < bgra.Width / reduction; column++)
                    Fill(x + column * magnification, y + row * magnification, magnification, magnification, Mean(bgra, column * reduction, row * reduction, reduction));
            }
        }

        /// <summary>One line of text with its top-left corner here; returns where it ends.</summary>
        public int Text(int x, int y, string text, uint color, bool doubled = true)
        {
            int scale = doubled ? 2 : 1;
            foreach (char letter in text)
            {
                bool[,] glyph = BitmapFont.Glyph(letter, doubled);
                for (int row = 0; row < glyph.GetLength(0); row++)
                {
                    for (int column = 0; column < glyph.GetLength(1); column++)
                    {
                        if (glyph[row, column])
                            Fill(x + column, y + row, 1, 1, color);
                    }
                }

                x += BitmapFont.Advance * scale;
            }

            return x;
        }

        public void Dispose() => Image.Dispose();

        private static uint Mean(Image bgra, int x0, int y0, int size)
        {
            int blue = 0, green = 0, red = 0;
            for (int y = y0; y < y0 + size; y++)
            {
                byte* pixel = bgra.Pixels + (long)y * bgra.Stride + 4 * x0;
                for (int x = 0; x < size; x++, pixel += 4)
                {
                    blue += pixel[0];
                    green += pixel[1];
                    red += pixel[2];
                }
            }

            int count = size * size;
            return (uint)(blue / count | green / count << 8 | red / count << 16);
        }

        private uint* Row(int y) => (uint*)(Image.Pixels + (long)y * Image.Stride);
    }
}
