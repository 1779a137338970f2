using System;
using LaserTracking.Kernels;

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
        /// <param name="bandCount">Of what will run it.</param>
        public ConvolutionLayer(FeatureMap input, FeatureMap output, SlidingWindow window, float[] weights, float[] bias, Clamp clamp, int bandCount)
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
                _columns = new FloatBuffer((long)output.Width * _depth * bandCount);
        }

        public override void Run(KernelRunner kernels, bool useVectors)
        {
            var work = new ConvolutionBands
            {
                Input = _input,
                Output = _output,
                Window = _window,
                Depth = _depth,
                Weights = _weights.Floats,
                Bias = _bias.Floats,
                Low = _clamp.Low,
                High = _clamp.High,
                UseVectors = useVectors,
                BandCount = kernels.BandCount,
                Columns = _columns == null ? null : _columns.Floats,
            };
            kernels.Run(&work, work.BandCount);
        }

        public void Dispose()
        {
            _weights.Dispose();
            _bias.Dispose();
            _columns?.Dispose();
        }
    }
}
