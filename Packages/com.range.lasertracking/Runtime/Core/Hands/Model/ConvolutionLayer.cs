using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>CONV_2D and FULLY_CONNECTED: the windows of one row of the output side by side, then a product of matrices.</summary>
    internal sealed unsafe class ConvolutionLayer : NetworkLayer, IDisposable
    {
        private readonly FeatureMap _input;
        private readonly FeatureMap _output;
        private readonly SlidingWindow _window;
        private readonly Clamp _clamp;
        private readonly FloatBuffer _weights;
        private readonly FloatBuffer _bias;
        private readonly FloatBuffer? _columns;
        private readonly int _depth;

        /// <param name="input">What the window goes over.</param>
        /// <param name="output">Of the size that the window gives.</param>
        /// <param name="window">Its geometry.</param>
        /// <param name="weights">[output][row][column][channel].</param>
        /// <param name="bias">One for each output.</param>
        /// <param name="clamp">Fused activation.</param>
        public ConvolutionLayer(FeatureMap input, FeatureMap output, SlidingWindow window, float[] weights, float[] bias, Clamp clamp)
        {
            _input = input;
            _output = output;
            _window = window;
            _clamp = clamp;
            _depth = window.Height * window.Width * input.Channels;
            _weights = new FloatBuffer(PointwiseKernel.PackedLength(output.Channels, _depth));
            PointwiseKernel.Pack(weights, output.Channels, _depth, _weights.Floats);
            _bias = new FloatBuffer(PointwiseKernel.PackedLength(output.Channels, 1));
            bias.CopyTo(new Span<float>(_bias.Floats, bias.Length));
            if (window.Height != 1 || window.Width != 1 || window.StrideX != 1 || window.StrideY != 1)
                _columns = new FloatBuffer((long)output.Width * _depth);
        }

        public override void Run(bool useVectors)
        {
            if (_columns == null)
            {
                Multiply(_input.Data, _input.Pixels, _output.Data, useVectors);
                return;
            }

            for (int y = 0; y < _output.Height; y++)
            {
                Gather(y, _columns.Floats);
                Multiply(_columns.Floats, _output.Width, _output.Row(y), useVectors);
            }
        }

        public void Dispose()
        {
            _weights.Dispose();
            _bias.Dispose();
            _columns?.Dispose();
        }

        private void Multiply(float* input, int rows, float* output, bool useVectors) =>
            PointwiseKernel.Multiply(input, rows, _depth, _weights.Floats, _bias.Floats, _output.Channels, output, _clamp.Low, _clamp.High, useVectors);

        private void Gather(int y, float* columns)
        {
            int channels = _input.Channels, span = _window.Width * channels;
            int top = y * _window.StrideY - _window.PaddingAbove(_input.Height);
            int left = -_window.PaddingLeft(_input.Width);
            for (int x = 0; x < _output.Width; x++, left += _window.StrideX)
            {
                // Of the window's columns, those within the picture.
                int from = Math.Max(0, -left), to = Math.Min(_window.Width, _input.Width - left);
                for (int k = 0; k < _window.Height; k++, columns += span)
                {
                    bool isInside = (uint)(top + k) < (uint)_input.Height && to > from;
                    if (!isInside || to - from < _window.Width)
                        new Span<float>(columns, span).Clear();
                    if (!isInside)
                        continue;
                    float* source = _input.Row(top + k) + (long)(left + from) * channels;
                    float* target = columns + from * channels;
                    int count = (to - from) * channels;
                    for (int i = 0; i < count; i++)
                        target[i] = source[i];
                }
            }
        }
    }
}
