using System;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>DEPTHWISE_CONV_2D with multiplier 1.</summary>
    internal sealed unsafe class DepthwiseLayer : NetworkLayer, IDisposable
    {
        private readonly FeatureMap _input;
        private readonly FeatureMap _output;
        private readonly SlidingWindow _window;
        private readonly Clamp _clamp;
        private readonly FloatBuffer _weights;
        private readonly FloatBuffer _bias;
        private readonly FloatBuffer _rings;
        private readonly int _rowLength;

        /// <param name="input">What the window goes over.</param>
        /// <param name="output">Of the size that the window gives and as many channels.</param>
        /// <param name="window">Its geometry.</param>
        /// <param name="weights">[row][column][channel].</param>
        /// <param name="bias">One for each channel.</param>
        /// <param name="clamp">Fused activation.</param>
        /// <param name="bandCount">Of what will run it.</param>
        public DepthwiseLayer(FeatureMap input, FeatureMap output, SlidingWindow window, float[] weights, float[] bias, Clamp clamp, int bandCount)
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

            _rings = new FloatBuffer((window.Height + 1L) * _rowLength * bandCount);
        }

        public override void Run(KernelRunner kernels, bool useVectors)
        {
            var work = new DepthwiseBands
            {
                Input = _input,
                Output = _output,
                Window = _window,
                Weights = _weights.Floats,
                Bias = _bias.Floats,
                Low = _clamp.Low,
                High = _clamp.High,
                UseVectors = useVectors,
                BandCount = kernels.BandCount,
                RowLength = _rowLength,
                Rings = _rings.Floats,
            };
            kernels.Run(&work, work.BandCount);
        }

        public void Dispose()
        {
            _weights.Dispose();
            _bias.Dispose();
            _rings.Dispose();
        }
    }
}
