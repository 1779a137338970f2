using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>Paints Gaussian spots of known centres on a background with noise: pictures whose truth is exact. Seeded.</summary>
    internal sealed unsafe class SpotPainter
    {
        private const double BlueShare = 0.4, RedShare = 0.3;
        private readonly SpotCase _case;
        private readonly Random _random;
        private readonly float[] _background;
        private readonly float[] _light;
        private readonly float[] _chroma;
        private readonly float[] _noise = new float[65536];
        private double _spare = double.NaN;

        public SpotPainter(SpotCase what, int seed)
        {
            _case = what;
            _random = new Random(seed);
            _light = new float[what.Width * what.Height];
            _chroma = new float[what.Width];
            _background = new float[what.Width * what.Height];
            for (int i = 0; i < _background.Length; i++)
                _background[i] = (float)BackgroundAt(i % what.Width, i / what.Width);
            for (int i = 0; i < _noise.Length; i++)
                _noise[i] = (float)(what.Noise * Gaussian());
        }

        /// <summary>Root of the sum of the squared channel shares: what three channels together are worth of one of full height.</summary>
        public static double ChannelGain => Math.Sqrt(1 + BlueShare * BlueShare + RedShare * RedShare);

        public void Clear() => Array.Clear(_light);

        /// <summary>Adds a spot; its centre may lie between pixels, a pixel averages over its square.</summary>
        public void Add(Vector2D center, double sigmaPx)
        {
            int reach = (int)Math.Ceiling(6 * sigmaPx) + 1;
            double variance = 2 * (sigmaPx * sigmaPx + 1.0 / 12);
            for (int y = Math.Max(0, (int)center.Y - reach); y <= Math.Min(_case.Height - 1, (int)center.Y + reach); y++)
            {
                for (int x = Math.Max(0, (int)center.X - reach); x <= Math.Min(_case.Width - 1, (int)center.X + reach); x++)
                {
                    double light = _case.Amplitude * Math.Exp(-((x - center.X) * (x - center.X) + (y - center.Y) * (y - center.Y)) / variance);
                    _light[y * _case.Width + x] += (float)(light * Math.Max(0, 1 + _case.Speckle * Gaussian()));
                }
            }
        }

        public double Uniform(double low, double high) => low + (high - low) * _random.NextDouble();

        public void Write(Frame frame, int index)
        {
            long timeUs = index * 33_333L;
            frame.Begin(index, timeUs);
            frame.Color.Reset(_case.Format, _case.Width, _case.Height, timeUs);
            Image image = frame.Color;
            uint key = (uint)_random.Next();
            for (int y = 0; y < _case.Height; y++)
            {
                byte* row = image.Pixels + (long)y * image.Stride, chroma = image.Pixels + (long)(_case.Height + y / 2) * image.Stride;
                for (int x = 0; x < _case.Width; x++)
                {
                    int i = y * _case.Width + x;
                    uint random = (uint)i * 0x9E3779B1u ^ key;
                    random = (random ^ random >> 15) * 0x846CA68Bu;
                    double blue = Level(i, BlueShare, random), green = Level(i, 1, random * 3 >> 5), red = Level(i, RedShare, random * 7 >> 9);
                    if (_case.Format == PixelFormat.Bgra32)
                    {
                        ((uint*)row)[x] = Round(blue) | Round(green) << 8 | Round(red) << 16 | 0xFF000000u;
                        continue;
                    }

                    double luma = 0.299 * red + 0.587 * green + 0.114 * blue;
                    row[x] = (byte)Round(luma);
                    _chroma[x / 2 * 2] += (float)((blue - luma) / (4 * 1.772));
                    _chroma[x / 2 * 2 + 1] += (float)((red - luma) / (4 * 1.402));
                    if (x % 2 == 1 && y % 2 == 1)
                    {
                        // The mean of four pixels.
                        chroma[x - 1] = (byte)Round(128 + _chroma[x - 1]);
                        chroma[x] = (byte)Round(128 + _chroma[x]);
                        _chroma[x - 1] = _chroma[x] = 0;
                    }
                }
            }
        }

        private static uint Round(double level) => (uint)Math.Max(0, Math.Min(255, Math.Round(level)));

        private double Level(int i, double share, uint random) => Math.Max(0, Math.Min(255, _background[i] + share * _light[i] + _noise[random >> 11 & 65535]));

        private double BackgroundAt(int x, int y) => _case.Background switch
        {
            SpotBackground.Dark => 25,
            SpotBackground.Bright => 150,
            _ => 60 + 25 * Math.Sin(x * 0.31 + 0.17 * y) + ((x / 13 + y / 17) % 2 == 0 ? 12 : -12),
        };

        private double Gaussian()
        {
            if (!double.IsNaN(_spare))
            {
                double kept = _spare;
                _spare = double.NaN;
                return kept;
            }

            double radius = Math.Sqrt(-2 * Math.Log(1 - _random.NextDouble())), angle = 2 * Math.PI * _random.NextDouble();
            _spare = radius * Math.Sin(angle);
            return radius * Math.Cos(angle);
        }
    }
}
