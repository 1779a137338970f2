using LaserTracking.Kernels;

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

        public override void Run(KernelRunner kernels, bool useVectors)
        {
            var work = new MaxPoolBands { Input = _input, Output = _output, Window = _window, Low = _clamp.Low, High = _clamp.High };
            kernels.Run(&work, _output.Height);
        }
    }
}
