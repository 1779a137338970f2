using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The published algorithm's pictures at reduced width, as floats of 0…255: steps 1 to 4 of its description. Everything that
    /// looks for dots in them is <see cref="PaperShotDetector"/>.
    /// </summary>
    internal sealed unsafe class PaperPlanes
    {
        private readonly PaperDetectorSettings _settings;
        private float[] _background = Array.Empty<float>();
        private float[] _difference = Array.Empty<float>();
        private float[] _excess = Array.Empty<float>();
        private float[] _spike = Array.Empty<float>();
        private float[] _scratch = Array.Empty<float>();
        private uint[] _sourceRow = Array.Empty<uint>();
        private float[] _columnSums = Array.Empty<float>();
        private int _sourceWidth;
        private int _sourceHeight;
        private PixelFormat _format;
        private bool _hasBackground;

        public PaperPlanes(PaperDetectorSettings settings) => _settings = settings;

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Source pixels per reduced pixel.</summary>
        public double ScaleX => (double)_sourceWidth / Width;

        public double ScaleY => (double)_sourceHeight / Height;

        /// <summary>I: mean of the three channels weighed as luma (BT.601).</summary>
        public float[] Intensity { get; private set; } = Array.Empty<float>();

        /// <summary>E: green excess, blurred.</summary>
        public float[] Excess => _excess;

        /// <summary>S.</summary>
        public float[] Score { get; private set; } = Array.Empty<float>();

        public void Reset() => _hasBackground = false;

        /// <summary>Takes a frame in. False when it was the first one of its kind: nothing can differ yet.</summary>
        public bool Update(Image image)
        {
            if (image.Width != _sourceWidth || image.Height != _sourceHeight || image.Format != _format)
                Resize(image);
            Reduce(image);
            int n = Width * Height;
            if (!_hasBackground)
            {
                Array.Copy(Intensity, _background, n);
                Array.Clear(_spike, 0, n);
                _hasBackground = true;
                return false;
            }

            float alpha = (float)_settings.BackgroundAlpha;
            for (int i = 0; i < n; i++)
            {
                _difference[i] = Math.Abs(Intensity[i] - _background[i]);
                _background[i] = alpha * _background[i] + (1 - alpha) * Intensity[i];
            }

            Blur(_difference);
            Blur(_excess);
            float gamma = (float)_settings.SpikeGamma;
            float spikeWeight = (float)_settings.SpikeWeight;
            float greenWeight = (float)_settings.GreenWeight;
            for (int i = 0; i < n; i++)
            {
                float spike = Math.Max(_difference[i], gamma * _spike[i]);
                _spike[i] = spike;
                Score[i] = spikeWeight * spike + greenWeight * _excess[i];
            }

            return true;
        }

        private void Resize(Image image)
        {
            _sourceWidth = image.Width;
            _sourceHeight = image.Height;
            _format = image.Format;
            Width = Math.Min(image.Width, _settings.ReducedWidthPx);
            Height = Math.Max(1, (int)Math.Round((double)image.Height * Width / image.Width));
            int n = Width * Height;
            Intensity = new float[n];
            Score = new float[n];
            _background = new float[n];
            _difference = new float[n];
            _excess = new float[n];
            _spike = new float[n];
            _scratch = new float[n];
            _sourceRow = new uint[image.Width];
            _columnSums = new float[3 * Width];
            _hasBackground = false;
        }

        /// <summary>Area average over whole source pixels; writes intensity and the green excess.</summary>
        private void Reduce(Image image)
        {
            fixed (uint* source = _sourceRow)
            {
                for (int y = 0; y < Height; y++)
                {
                    int top = (int)((long)y * _sourceHeight / Height);
                    int bottom = Math.Max(top + 1, (int)((long)(y + 1) * _sourceHeight / Height));
                    Array.Clear(_columnSums, 0, _columnSums.Length);
                    for (int sy = top; sy < bottom; sy++)
                    {
                        PixelRow.ToBgra(image, sy, 0, _sourceWidth, source);
                        for (int x = 0; x < Width; x++)
                            AddColumn(source, x);
                    }

                    for (int x = 0; x < Width; x++)
                    {
                        float scale = 1f / ((bottom - top) * (Right(x) - Left(x)));
                        float b = _columnSums[3 * x] * scale, g = _columnSums[3 * x + 1] * scale, r = _columnSums[3 * x + 2] * scale;
                        Intensity[y * Width + x] = 0.114f * b + 0.587f * g + 0.299f * r;
                        _excess[y * Width + x] = Math.Max(0, g - 0.5f * (r + b));
                    }
                }
            }
        }

        private int Left(int x) => (int)((long)x * _sourceWidth / Width);

        private int Right(int x) => Math.Max(Left(x) + 1, (int)((long)(x + 1) * _sourceWidth / Width));

        private void AddColumn(uint* source, int x)
        {
            uint b = 0, g = 0, r = 0;
            int right = Right(x);
            for (int sx = Left(x); sx < right; sx++)
            {
                uint pixel = source[sx];
                b += pixel & 255;
                g += pixel >> 8 & 255;
                r += pixel >> 16 & 255;
            }

            _columnSums[3 * x] += b;
            _columnSums[3 * x + 1] += g;
            _columnSums[3 * x + 2] += r;
        }

        /// <summary>3×3 Gaussian (1 2 1) ⊗ (1 2 1) / 16, edges repeated.</summary>
        private void Blur(float[] plane)
        {
            int w = Width, h = Height;
            for (int y = 0; y < h; y++)
            {
                int row = y * w;
                for (int x = 0; x < w; x++)
                    _scratch[row + x] = (plane[row + Math.Max(0, x - 1)] + 2 * plane[row + x] + plane[row + Math.Min(w - 1, x + 1)]) * 0.25f;
            }

            for (int y = 0; y < h; y++)
            {
                int above = Math.Max(0, y - 1) * w, row = y * w, below = Math.Min(h - 1, y + 1) * w;
                for (int x = 0; x < w; x++)
                    plane[row + x] = (_scratch[above + x] + 2 * _scratch[row + x] + _scratch[below + x]) * 0.25f;
            }
        }
    }
}
