using System;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>LOGISTIC: 1 / (1 + e^-x).</summary>
    internal sealed unsafe class LogisticLayer : NetworkLayer
    {
        private readonly FeatureMap _input;
        private readonly FeatureMap _output;

        public LogisticLayer(FeatureMap input, FeatureMap output)
        {
            _input = input;
            _output = output;
        }

        public override void Run(KernelRunner kernels, bool useVectors)
        {
            for (int i = 0; i < _output.Count; i++)
                _output.Data[i] = (float)(1 / (1 + Math.Exp(-_input.Data[i])));
        }
    }
}
