using System;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>Draws small test pictures: a wall with noise, laser dots as light added before the sensor clips, shapes. Seeded.</summary>
    internal sealed unsafe class FrameBuilder
    {
        private static readonly float[] Normals = NormalTable();
        private readonly float[] _light;
        private uint _random;

        /// <param name="width">Pixels.</param>
        /// <param name="height">Pixels.</param>
        /// <param name="seed">Of the noise, not 0.</param>
        public FrameBuilder(int width, int height, uint seed = 12345)
        {
            _random = seed;
            Width = width;
            Height = height;
            _light = new float[width * height * 3];
        }

        public int Width { get; }

        public int Height { get; }

        public double NoiseSigma { get; set; } = 1;

        /// <summary>Blue, green, red of the wall, which grows a little brighter to the right.</summary>
        public FrameBuilder Wall(float blue, float green, float red)
        {
            for (int x = 0; x < Width; x++)
            {
                float slope = 0.9f + 0.2f * x / Width;
                _light[3 * x] = blue * slope;
                _light[3 * x + 1] = green * slope;
                _light[3 * x + 2] = red * slope;
            }

            for (int y = 1; y < Height; y++)
                Array.Copy(_light, 0, _light, 3 * Width * y, 3 * Width);

            return this;
        }

        public FrameBuilder Multiply(float gain)
        {
            for (int i = 0; i < _light.Length; i++)
                _light[i] *= gain;
            return this;
        }

        public FrameBuilder Box(int x, int y, int width, int height, float blue, float green, float red)
        {
            for (int py = Math.Max(0, y); py < Math.Min(Height, y + height); py++)
            {
                for (int px = Math.Max(0, x); px < Math.Min(Width, x + width); px++)
                {
                    int i = 3 * (py * Width + px);
                    _light[i] = blue;
                    _light[i + 1] = green;
                    _light[i + 2] = red;
                }
            }

            return this;
        }

        /// <summary>Green light at a place.</summary>
        public float Gray(int x, int y) => _light[(3 * (y * Width + x)) + 1];

        public void Gray(int x, int y, float level)
        {
            int i = 3 * (y * Width + x);
            _light[i] = _light[i + 1] = _light[i + 2] = level;
        }

        /// <summary>A green laser: far over full brightness in green, with enough of the others to clip to white in the core.</summary>
        public FrameBuilder GreenDot(double x, double y, double sigma = 2, double strength = 1) =>
            Dot(x, y, sigma, 220 * strength, 1400 * strength, 140 * strength);

        public FrameBuilder RedDot(double x, double y, double sigma = 2, double strength = 1) =>
            Dot(x, y, sigma, 140 * strength, 220 * strength, 1400 * strength);

        public FrameBuilder Dot(double x, double y, double sigma, double blue, double green, double red)
        {
            int reach = (int)Math.Ceiling(8 * sigma), x0 = (int)x, y0 = (int)y;
            for (int py = Math.Max(0, y0 - reach); py < Math.Min(Height, y0 + reach + 2); py++)
            {
                for (int px = Math.Max(0, x0 - reach); px < Math.Min(Width, x0 + reach + 2); px++)
                {
                    double r2 = (px - x) * (px - x) + (py - y) * (py - y);
                    if (r2 > 64 * sigma * sigma)
                        continue;
                    double falloff = Math.Exp(-0.5 * r2 / (sigma * sigma));
                    int i = 3 * (py * Width + px);
                    _light[i] += (float)(blue * falloff);
                    _light[i + 1] += (float)(green * falloff);
                    _light[i + 2] += (float)(red * falloff);
                }
            }

            return this;
        }

        /// <summary>Green light smeared along a line.</summary>
        public FrameBuilder GreenStreak(double x0, double y0, double x1, double y1, double sigma = 1.5)
        {
            const int Steps = 40;
            for (int i = 0; i <= Steps; i++)
                GreenDot(x0 + (x1 - x0) * i / Steps, y0 + (y1 - y0) * i / Steps, sigma, 6.0 / Steps);
            return this;
        }

        /// <summary>Clips, adds noise, writes the frame.</summary>
        public void Write(Frame frame, int index, long timeUs, PixelFormat format = PixelFormat.Bgra32)
        {
            frame.Begin(index, timeUs);
            frame.Color.Reset(format, Width, Height, timeUs);
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                    WritePixel(frame.Color, x, y);
            }
        }

        private void WritePixel(Image image, int x, int y)
        {
            int i = 3 * (y * Width + x);
            if (image.Format == PixelFormat.Gray8)
            {
                image.Pixels[((long)y * image.Stride) + x] = (byte)Clip(0.114f * _light[i] + 0.587f * _light[i + 1] + 0.299f * _light[i + 2] + Noise(Next(ref _random) >> 20));
                return;
            }


            // Three places of twelve bits out of one word: its upper bits, its middle ones, and those that a multiplication mixes.
            uint random = Next(ref _random);
            int blue = Clip(_light[i] + Noise(random >> 20)), green = Clip(_light[i + 1] + Noise(random >> 8 & 4095)), red = Clip(_light[i + 2] + Noise(random * 2654435769 >> 20));
            if (image.Format == PixelFormat.Bgra32)
            {
                ((uint*)(image.Pixels + (long)y * image.Stride))[x] = PixelRow.Pack(blue, green, red);
                return;
            }

            float luma = 0.299f * red + 0.587f * green + 0.114f * blue;
            byte u = (byte)Clip(128 + (blue - luma) / 1.772f), v = (byte)Clip(128 + (red - luma) / 1.402f);
            byte* row = image.Pixels + (long)y * image.Stride;
            switch (image.Format)
            {
                case PixelFormat.Nv12:
                    row[x] = (byte)Clip(luma);
                    byte* chroma = image.Pixels + (long)(Height + y / 2) * image.Stride;
                    Blend(chroma + (x & ~1), u, x % 2 + y % 2 == 0);
                    Blend(chroma + (x | 1), v, x % 2 + y % 2 == 0);
                    break;
                case PixelFormat.Yuy2:
                    row[2 * x] = (byte)Clip(luma);
                    Blend(row + 4 * (x / 2) + 1, u, x % 2 == 0);
                    Blend(row + 4 * (x / 2) + 3, v, x % 2 == 0);
                    break;
            }
        }

        /// <summary>Chroma is shared by neighbours: the mean of what they say.</summary>
        private static void Blend(byte* chroma, byte value, bool isFirst) => *chroma = isFirst ? value : (byte)((*chroma + value + 1) / 2);

        private static int Clip(float value) => value < 0 ? 0 : value > 255 ? 255 : (int)(value + 0.5f);

        /// <summary>From a table of 4096: pictures are many, and noise is most of their drawing.</summary>
        private float Noise(uint place) => NoiseSigma <= 0 ? 0 : (float)NoiseSigma * Normals[place];

        private static float[] NormalTable()
        {
            uint random = 54321;
            var table = new float[4096];
            for (int i = 0; i < table.Length; i++)
                table[i] = (float)Normal(ref random);
            return table;
        }

        /// <summary>Sum of four uniform numbers: near enough to a normal one.</summary>
        private static double Normal(ref uint random)
        {
            double sum = -2;
            for (int i = 0; i < 4; i++)
                sum += Next(ref random) / 4294967296.0;
            return sum * 1.7320508;
        }

        private static uint Next(ref uint random)
        {
            random ^= random << 13;
            random ^= random >> 17;
            random ^= random << 5;
            return random;
        }
    }
}
