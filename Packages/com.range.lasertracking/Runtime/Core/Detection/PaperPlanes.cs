using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The published algorithm's pictures at reduced width, as floats of 0…255: steps 1 to 4 of its description. Everything that
    /// looks for dots in them is <see cref="PaperShotDetector"/>.
    /// </summary>
    internal sealed unsafe class PaperPlanes
    {
        private readonly PaperDetectorSettings _settings;
        private readonly KernelRunner _kernels;
        private float[] _background = Array.Empty<float>();
        private float[] _nextBackground = Array.Empty<float>();
        private float[] _excess = Array.Empty<float>();
        private float[] _spike = Array.Empty<float>();
        private float[] _rows = Array.Empty<float>();
        private uint[] _sourceRows = Array.Empty<uint>();
        private int[] _edges = Array.Empty<int>();
        private int _sourceWidth;
        private int _sourceHeight;
        private PixelFormat _format;
        private int _bandCount;
        private int _sourceRowsLength;
        private bool _hasBackground;

        public PaperPlanes(PaperDetectorSettings settings, KernelRunner kernels)
        {
            _settings = settings;
            _kernels = kernels;
        }

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
            fixed (int* edges = _edges)
            fixed (uint* sourceRows = _sourceRows)
            fixed (float* intensity = Intensity, background = _background, next = _nextBackground, excess = _excess, spike = _spike, score = Score, rows = _rows)
            {
                var work = new PaperBands
                {
                    Source = image,
                    Width = Width,
                    Height = Height,
                    HasBackground = _hasBackground,
                    UseVectors = _settings.UseVectors,
                    BandCount = _bandCount,
                    Alpha = (float)_settings.BackgroundAlpha,
                    Gamma = (float)_settings.SpikeGamma,
                    SpikeWeight = (float)_settings.SpikeWeight,
                    ExcessWeight = (float)_settings.GreenWeight,
                    Edges = edges,
                    Intensity = intensity,
                    Background = background,
                    NextBackground = next,
                    Excess = excess,
                    Spike = spike,
                    Score = score,
                    Rows = rows,
                    SourceRows = sourceRows,
                    SourceRowsLength = _sourceRowsLength,
                };
                _kernels.Run(&work, _bandCount);
            }

            if (_hasBackground)
            {
                float[] old = _background;
                _background = _nextBackground;
                _nextBackground = old;
                return true;
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
            _nextBackground = new float[n];
            _excess = new float[n];
            _spike = new float[n];
            _bandCount = Math.Min(_kernels.BandCount, Height);
            _rows = new float[PaperBands.RowsPerBand * Width * _bandCount];
            _sourceRowsLength = image.Format == PixelFormat.Bgra32 ? 0 : image.Width * (image.Height / Height + 2);
            _sourceRows = new uint[_sourceRowsLength * _bandCount];
            _edges = new int[Width + 1];
            for (int x = 0; x <= Width; x++)
                _edges[x] = (int)((long)x * _sourceWidth / Width);
            _hasBackground = false;
        }
    }
}
