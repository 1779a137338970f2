using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>MAX_POOL_2D: the largest value under the window, padding left out.</summary>
    internal sealed unsafe class MaxPoolLayer : NetworkLayer
    {
        private readonly FeatureMap _input;
        private readonly FeatureMap _output;
        private readonly SlidingWindow _window;
        private readonly Clamp _clamp;

        public MaxPoolLayer(FeatureMap input, FeatureMap output, SlidingWindow window, Clamp clamp)
        {
            _input = input;
            _output = output;
            _window = window;
            _clamp = clamp;
        }

        public override void Run(bool useVectors)
        {
            for (int y = 0; y < _output.Height; y++)
            {
                int top = y * _window.StrideY - _window.PaddingAbove(_input.Height);
                for (int x = 0; x < _output.Width; x++)
                {
                    int left = x * _window.StrideX - _window.PaddingLeft(_input.Width);
                    Pool(_output.Row(y) + (long)x * _output.Channels, top, left);
                }
            }
        }

        private void Pool(float* output, int top, int left)
        {
            int channels = _output.Channels;
            new Span<float>(output, channels).Fill(float.NegativeInfinity);
            for (int y = Math.Max(0, top); y < Math.Min(_input.Height, top + _window.Height); y++)
            {
                for (int x = Math.Max(0, left); x < Math.Min(_input.Width, left + _window.Width); x++)
                {
                    float* source = _input.Row(y) + (long)x * channels;
                    for (int c = 0; c < channels; c++)
                        output[c] = source[c] > output[c] ? source[c] : output[c];
                }
            }

            for (int c = 0; c < channels; c++)
                output[c] = Math.Max(_clamp.Low, Math.Min(_clamp.High, output[c]));
        }
    }
}
