using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>
    /// What a camera sees of a projected picture without end that may move, and of a room with things on its wall that moves with the
    /// camera only; fractions of a pixel by linear interpolation. Seeded.
    /// </summary>
    internal sealed unsafe class DrawnView
    {
        public const int Width = 640, Height = 360;

        /// <summary>The picture repeats after so many pixels, a power of two; the room has so many beyond every side.</summary>
        private const int Period = 1024, Margin = 64;

        private const int RoomWidth = Width + 2 * Margin, RoomHeight = Height + 2 * Margin;

        /// <summary>The projector's black, and its white on the wall.</summary>
        private const float Black = 12, Light = 0.8f;

        private readonly Random _random;
        private readonly float[] _picture = new float[Period * Period];
        private readonly float[]? _wall, _lit;
        private readonly float[] _row = new float[Width], _litRow = new float[Width], _wallRow = new float[Width];
        private readonly sbyte[] _noise = new sbyte[4096];

        /// <param name="seed">Of everything.</param>
        /// <param name="hasRoom">3 to 8 % of the view show the room on every side; else the picture fills it.</param>
        public DrawnView(int seed, bool hasRoom)
        {
            _random = new Random(seed);
            Paint(_picture, Period, Period, Uniform(40, 120), _random.Next(60, 240), 12, 90, 230);
            Smooth(_picture, Period, Period, _random.Next(1, 4));
            if (hasRoom)
            {
                _wall = new float[RoomWidth * RoomHeight];
                _lit = new float[RoomWidth * RoomHeight];
                Paint(_wall, RoomWidth, RoomHeight, Uniform(14, 40), _random.Next(0, 60), 8, 60, 90);
                Smooth(_wall, RoomWidth, RoomHeight, 1);
                PaintLit();
            }

            double sigma = Uniform(0.5, 2.5);
            for (int i = 0; i < _noise.Length; i++)
                _noise[i] = (sbyte)Math.Round(sigma * Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())) * Math.Cos(2 * Math.PI * _random.NextDouble()));
        }

        /// <param name="target">Receives the picture, Gray8.</param>
        /// <param name="picture">How far the projected picture has moved on the wall.</param>
        /// <param name="camera">How far everything has moved in the camera's view.</param>
        /// <param name="frame">Number of the frame, for the noise.</param>
        /// <param name="targets">Dark discs that move about in the projected picture.</param>
        /// <param name="exposure">Factor on all levels.</param>
        public void Draw(Image target, Vector2D picture, Vector2D camera, int frame, int targets, double exposure)
        {
            target.Reset(PixelFormat.Gray8, Width, Height, target.TimeUs);
            ulong state = ((ulong)frame * 0x9E3779B97F4A7C15) + 0x1234567;
            for (int y = 0; y < Height; y++)
            {
                Sample(_picture, Period, y, picture + camera, _row);
                DrawTargets(y, camera, frame, targets);
                if (_wall != null)
                {
                    Sample(_wall, 0, y, camera, _wallRow);
                    Sample(_lit!, 0, y, camera, _litRow);
                }

                byte* to = target.Pixels + (long)y * target.Stride;
                for (int x = 0; x < Width; x++)
                {
                    float level = _wall == null ? _row[x] : _wallRow[x] + _litRow[x] * (Black + Light * _row[x]);
                    state ^= state << 13;
                    state ^= state >> 7;
                    state ^= state << 17;
                    to[x] = (byte)Math.Clamp((exposure * level) + _noise[state >> 40 & 4095] + 0.5, 0, 255);
                }
            }
        }

        /// <summary>One row of a canvas that lies displaced; with a period it repeats, without it has the room's margin.</summary>
        private static void Sample(float[] canvas, int period, int y, Vector2D displaced, float[] row)
        {
            double left = Math.Floor(-displaced.X), top = Math.Floor(y - displaced.Y);
            float fx = (float)(-displaced.X - left), fy = (float)(y - displaced.Y - top);
            int x0 = (int)left, y0 = (int)top, y1 = y0 + 1, width = period > 0 ? period : RoomWidth;
            if (period > 0)
                (y0, y1) = (y0 & (period - 1), y1 & (period - 1));
            else
                (x0, y0, y1) = (x0 + Margin, Math.Clamp(y0 + Margin, 0, RoomHeight - 1), Math.Clamp(y1 + Margin, 0, RoomHeight - 1));
            for (int x = 0; x < Width; x++)
            {
                int a = x0 + x, b = a + 1;
                (a, b) = period > 0 ? (a & (period - 1), b & (period - 1)) : (Math.Clamp(a, 0, width - 1), Math.Clamp(b, 0, width - 1));
                float upper = canvas[(y0 * width) + a] * (1 - fx) + canvas[(y0 * width) + b] * fx, lower = canvas[(y1 * width) + a] * (1 - fx) + canvas[(y1 * width) + b] * fx;
                row[x] = upper * (1 - fy) + lower * fy;
            }
        }

        private void DrawTargets(int y, Vector2D camera, int frame, int targets)
        {
            for (int i = 0; i < targets; i++)
            {
                double x = Width * (0.5 + 0.42 * Math.Sin(0.02 * frame * (1 + 0.3 * i) + 2 * i)) + camera.X, middle = Height * (0.35 + 0.1 * i) + camera.Y, radius = 10 + 4 * i;
                double half = Math.Sqrt(Math.Max(0, radius * radius - (y - middle) * (y - middle)));
                for (int at = Math.Max(0, (int)(x - half)); at < Math.Min(Width, x + half) && half > 0; at++)
                    _row[at] = 30;
            }
        }

        /// <summary>Boxes and discs of all sizes and levels, over the edges too.</summary>
        private void Paint(float[] canvas, int width, int height, double level, int shapes, double least, double most, double brightest)
        {
            Array.Fill(canvas, (float)level);
            for (int i = 0; i < shapes; i++)
            {
                int w = (int)Uniform(least, most), h = (int)Uniform(least, most), x0 = _random.Next(width), y0 = _random.Next(height);
                bool isDisc = _random.Next(2) == 0;
                float value = (float)Uniform(5, brightest);
                for (int y = 0; y < h; y++)
                for (int x = 0; x < w; x++)
                {
                    double u = 2.0 * x / w - 1, v = 2.0 * y / h - 1;
                    if (!isDisc || u * u + v * v <= 1)
                        canvas[((y0 + y) % height * width) + ((x0 + x) % width)] = value;
                }
            }
        }

        private static void Smooth(float[] canvas, int width, int height, int rounds)
        {
            var line = new float[Math.Max(width, height)];
            for (int round = 0; round < rounds; round++)
            {
                for (int y = 0; y < height; y++)
                    SmoothLine(canvas, y * width, 1, width, line);
                for (int x = 0; x < width; x++)
                    SmoothLine(canvas, x, width, height, line);
            }
        }

        private static void SmoothLine(float[] canvas, int first, int step, int count, float[] line)
        {
            for (int i = 0; i < count; i++)
                line[i] = canvas[first + i * step];
            for (int i = 0; i < count; i++)
                canvas[first + i * step] = 0.25f * line[(i + count - 1) % count] + 0.5f * line[i] + 0.25f * line[(i + 1) % count];
        }

        /// <summary>Where the projector's light falls: a quadrilateral somewhat askew.</summary>
        private void PaintLit()
        {
            var corners = new Vector2D[4];
            for (int i = 0; i < 4; i++)
            {
                double x = Uniform(0.03, 0.08) * Width, y = Uniform(0.03, 0.08) * Height;
                corners[i] = new Vector2D(i is 1 or 2 ? Width - x : x, i >= 2 ? Height - y : y);
            }

            for (int y = 0; y < RoomHeight; y++)
            for (int x = 0; x < RoomWidth; x++)
            {
                double inside = double.PositiveInfinity;
                for (int i = 0; i < 4; i++)
                {
                    Vector2D from = corners[i], way = corners[(i + 1) % 4] - from, at = new Vector2D(x - Margin, y - Margin) - from;
                    inside = Math.Min(inside, (way.X * at.Y - way.Y * at.X) / way.Length);
                }

                _lit![y * RoomWidth + x] = (float)Math.Clamp(inside + 0.5, 0, 1);
            }
        }

        private double Uniform(double low, double high) => low + (high - low) * _random.NextDouble();
    }
}
