using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>ADD of two tensors of one shape.</summary>
    internal sealed unsafe class AddLayer : NetworkLayer
    {
        private readonly FeatureMap _first;
        private readonly FeatureMap _second;
        private readonly FeatureMap _output;
        private readonly Clamp _clamp;

        public AddLayer(FeatureMap first, FeatureMap second, FeatureMap output, Clamp clamp)
        {
            _first = first;
            _second = second;
            _output = output;
            _clamp = clamp;
        }

        public override void Run(KernelRunner kernels, bool useVectors)
        {
            var work = new AddBands
            {
                First = _first.Data,
                Second = _second.Data,
                Sum = _output.Data,
                Count = _output.Count,
                Low = _clamp.Low,
                High = _clamp.High,
                UseVectors = useVectors,
            };
            kernels.Run(&work, work.BandCount);
        }
    }
}
