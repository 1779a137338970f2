using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>MEAN over height and width: one value a channel.</summary>
    internal sealed unsafe class MeanLayer : NetworkLayer
    {
        private readonly FeatureMap _input;
        private readonly FeatureMap _output;

        public MeanLayer(FeatureMap input, FeatureMap output)
        {
            _input = input;
            _output = output;
        }

        public override void Run(KernelRunner kernels, bool useVectors)
        {
            int channels = _input.Channels, pixels = _input.Pixels;
            for (int c = 0; c < channels; c++)
                _output.Data[c] = 0;
            for (int p = 0; p < pixels; p++)
            {
                float* source = _input.Data + (long)p * channels;
                for (int c = 0; c < channels; c++)
                    _output.Data[c] += source[c];
            }

            for (int c = 0; c < channels; c++)
                _output.Data[c] /= pixels;
        }
    }
}
