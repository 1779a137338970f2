using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// The projector's light alone as a grey picture: half way up is neither black nor white, and the contrast is drawn out over the
    /// whole range. With it its halvings. One memory for all pictures.
    /// </summary>
    internal sealed unsafe class SignalPicture : IDisposable
    {
        public const int MostLevels = 6;

        /// <summary>The level of no signal.</summary>
        public const int Middle = 128;

        /// <summary>From the middle to the strongest signal, levels.</summary>
        public const int Swing = 120;

        /// <summary>Share of the pixels that may be brighter or darker than the range holds: lamps switched, a reflection.</summary>
        private const double ClippedShare = 0.002;

        private const double LargestGain = 24;

        private readonly Image[] _levels = new Image[MostLevels];
        private readonly int[] _histogram = new int[512];
        private float[] _difference = Array.Empty<float>();
        private double _gain = 1;

        public SignalPicture()
        {
            for (int i = 0; i < MostLevels; i++)
                _levels[i] = new Image();
        }

        /// <summary>Full resolution.</summary>
        public Image Full => _levels[0];

        public void SetToDifference(HeldPicture bright, HeldPicture dark)
        {
            MakeRoom(bright);
            bright.Subtract(dark, _difference);
            Render(bright.Width, bright.Height);
        }

        public void SetToFlattened(HeldPicture picture)
        {
            MakeRoom(picture);
            picture.Flatten(_difference);
            Render(picture.Width, picture.Height);
        }

        /// <summary>The picture halved so many times, 0 to 5; one pixel of it is the mean of 4^level.</summary>
        public Image Level(int level) => _levels[level];

        /// <summary>Signal in levels of the camera's pictures, above zero where it is white; bilinear, the place is inside.</summary>
        public double At(Vector2D px)
        {
            double x = Math.Max(0, Math.Min(Full.Width - 1.001, px.X)), y = Math.Max(0, Math.Min(Full.Height - 1.001, px.Y));
            int left = (int)x, top = (int)y;
            double fx = x - left, fy = y - top;
            byte* p = Full.Pixels + (long)top * Full.Stride + left, q = p + Full.Stride;
            double above = p[0] + fx * (p[1] - p[0]), below = q[0] + fx * (q[1] - q[0]);
            return (above + fy * (below - above) - Middle) / _gain;
        }

        public void Dispose()
        {
            foreach (Image image in _levels)
                image.Dispose();
        }

        private void MakeRoom(HeldPicture picture)
        {
            if (_difference.Length != picture.Width * picture.Height)
                _difference = new float[picture.Width * picture.Height];
        }

        private void Render(int width, int height)
        {
            Array.Clear(_histogram, 0, _histogram.Length);
            foreach (float value in _difference)
                _histogram[(int)Math.Min(_histogram.Length - 1, Math.Abs(value) * 2)]++;
            int range = _histogram.Length - 1;
            for (int above = _histogram[range]; range > 1 && above <= ClippedShare * _difference.Length; above += _histogram[range])
                range--;
            _gain = Math.Min(LargestGain, Swing / ((range + 1) / 2.0));
            Full.Reset(PixelFormat.Gray8, width, height, 0);
            float gain = (float)_gain;
            for (int y = 0; y < height; y++)
            {
                byte* row = Full.Pixels + (long)y * Full.Stride;
                for (int x = 0; x < width; x++)
                    row[x] = (byte)Math.Max(0, Math.Min(255, Middle + 0.5f + gain * _difference[y * width + x]));
            }

            for (int i = 1; i < MostLevels; i++)
                GrayConversion.Halve(_levels[i - 1], _levels[i]);
        }
    }
}
