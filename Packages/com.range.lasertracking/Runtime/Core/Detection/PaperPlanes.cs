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
        private float[] _excess = Array.Empty<float>();
        private float[] _spike = Array.Empty<float>();
        private float[] _rows = Array.Empty<float>();
        private uint[] _sourceRows = Array.Empty<uint>();
        private int[] _edges = Array.Empty<int>();
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
            fixed (float* rows = _rows)
            {
                // Six blurred rows: the last three of the difference, then the last three of the excess; two raw ones after them.
                float* difference = rows + 6 * Width, excess = rows + 7 * Width;
                for (int y = 0; y < Height; y++)
                {
                    ReduceRow(image, y, excess);
                    if (!_hasBackground)
                        continue;
                    fixed (float* intensity = Intensity, background = _background)
                        PaperKernel.Differ(intensity + y * Width, background + y * Width, Width, (float)_settings.BackgroundAlpha, difference, _settings.UseVectors);
                    PaperKernel.BlurRow(difference, Width, rows + y % 3 * Width, _settings.UseVectors);
                    PaperKernel.BlurRow(excess, Width, rows + (3 + y % 3) * Width, _settings.UseVectors);
                    if (y > 0)
                        FinishRow(y - 1, rows);
                }

                if (_hasBackground)
                {
                    FinishRow(Height - 1, rows);
                    return true;
                }
            }

            Array.Copy(Intensity, _background, Width * Height);
            Array.Clear(_spike, 0, Width * Height);
            _hasBackground = true;
            return false;
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
            _excess = new float[n];
            _spike = new float[n];
            _rows = new float[8 * Width];
            _sourceRows = new uint[image.Format == PixelFormat.Bgra32 ? 0 : image.Width * (image.Height / Height + 2)];
            _edges = new int[Width + 1];
            for (int x = 0; x <= Width; x++)
                _edges[x] = (int)((long)x * _sourceWidth / Width);
            _hasBackground = false;
        }

        /// <summary>Area average over whole source pixels; writes intensity and the raw green excess.</summary>
        private void ReduceRow(Image image, int y, float* excess)
        {
            int top = (int)((long)y * _sourceHeight / Height);
            int bottom = Math.Max(top + 1, (int)((long)(y + 1) * _sourceHeight / Height));
            fixed (uint* converted = _sourceRows)
            fixed (int* edges = _edges)
            fixed (float* intensity = Intensity)
            {
                byte* source = image.Pixels + (long)top * image.Stride;
                long stride = image.Stride;
                if (_format != PixelFormat.Bgra32)
                {
                    for (int sy = top; sy < bottom; sy++)
                        ReductionKernel.Row(image, sy, 1, converted + (sy - top) * _sourceWidth, _settings.UseVectors);
                    source = (byte*)converted;
                    stride = 4L * _sourceWidth;
                }

                PaperKernel.Reduce(source, bottom - top, stride, edges, Width, intensity + y * Width, excess, _settings.UseVectors);
            }
        }

        /// <summary>The second half of the 3×3 Gaussian (1 2 1) ⊗ (1 2 1) / 16, edges repeated; then spike map and score.</summary>
        private void FinishRow(int y, float* rows)
        {
            int above = Math.Max(0, y - 1) % 3 * Width, middle = y % 3 * Width, below = Math.Min(Height - 1, y + 1) % 3 * Width, row = y * Width;
            float* difference = rows + 6 * Width;
            float* blurred = rows + 3 * Width;
            fixed (float* excess = _excess, spike = _spike, score = Score)
            {
                PaperKernel.BlurColumns(rows + above, rows + middle, rows + below, Width, difference, _settings.UseVectors);
                PaperKernel.BlurColumns(blurred + above, blurred + middle, blurred + below, Width, excess + row, _settings.UseVectors);
                PaperKernel.Score(difference, excess + row, spike + row, Width, (float)_settings.SpikeGamma, (float)_settings.SpikeWeight, (float)_settings.GreenWeight, score + row, _settings.UseVectors);
            }
        }
    }
}
