using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// DEPTHWISE_CONV_2D with multiplier 1. The rows under the window lie in a ring of padded copies, so that the kernel knows no
    /// borders.
    /// </summary>
    internal sealed unsafe class DepthwiseLayer : NetworkLayer, IDisposable
    {
        private readonly FeatureMap _input;
        private readonly FeatureMap _output;
        private readonly SlidingWindow _window;
        private readonly Clamp _clamp;
        private readonly FloatBuffer _weights;
        private readonly FloatBuffer _bias;
        private readonly FloatBuffer _ring;
        private readonly int _rowLength;

        /// <param name="input">What the window goes over.</param>
        /// <param name="output">Of the size that the window gives and as many channels.</param>
        /// <param name="window">Its geometry.</param>
        /// <param name="weights">[row][column][channel].</param>
        /// <param name="bias">One for each channel.</param>
        /// <param name="clamp">Fused activation.</param>
        public DepthwiseLayer(FeatureMap input, FeatureMap output, SlidingWindow window, float[] weights, float[] bias, Clamp clamp)
        {
            _input = input;
            _output = output;
            _window = window;
            _clamp = clamp;
            _weights = new FloatBuffer(weights.Length);
            weights.CopyTo(new Span<float>(_weights.Floats, weights.Length));
            _bias = new FloatBuffer(bias.Length);
            bias.CopyTo(new Span<float>(_bias.Floats, bias.Length));
            _rowLength = Math.Max(input.Width + window.PaddingLeft(input.Width), (output.Width - 1) * window.StrideX + window.Width) * input.Channels;

            // One row more than the window has: zeros, in place of those above and below the picture.
            _ring = new FloatBuffer((window.Height + 1L) * _rowLength);
        }

        public override void Run(bool useVectors)
        {
            float* zeros = _ring.Floats + (long)_window.Height * _rowLength;
            float** rows = stackalloc float*[_window.Height];
            int above = _window.PaddingAbove(_input.Height), filled = 0;
            for (int y = 0; y < _output.Height; y++)
            {
                int top = y * _window.StrideY - above;
                filled = Math.Max(filled, top);
                for (; filled < Math.Min(_input.Height, top + _window.Height); filled++)
                    Fill(filled);
                for (int k = 0; k < _window.Height; k++)
                    rows[k] = (uint)(top + k) < (uint)_input.Height ? RingRow(top + k) : zeros;
                DepthwiseKernel.Row(rows, _window.Height, _window.Width, _window.StrideX, _input.Channels, _weights.Floats, _bias.Floats, _output.Row(y),
                    _output.Width, _clamp.Low, _clamp.High, useVectors);
            }
        }

        public void Dispose()
        {
            _weights.Dispose();
            _bias.Dispose();
            _ring.Dispose();
        }

        private float* RingRow(int y) => _ring.Floats + (long)(y % _window.Height) * _rowLength;

        /// <summary>The padding stays zero from the start: only the picture's part is ever written.</summary>
        private void Fill(int y)
        {
            int count = _input.Width * _input.Channels;
            float* target = RingRow(y) + _window.PaddingLeft(_input.Width) * _input.Channels;
            new ReadOnlySpan<float>(_input.Row(y), count).CopyTo(new Span<float>(target, count));
        }
    }
}
