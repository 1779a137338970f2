using System;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

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

        public override void Run(bool useVectors)
        {
            float* a = _first.Data;
            float* b = _second.Data;
            float* sum = _output.Data;
            float low = _clamp.Low, high = _clamp.High;
            int i = 0, count = _output.Count;
#if NET8_0_OR_GREATER
            if (useVectors)
            {
                Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
                for (; i + 8 <= count; i += 8)
                    Avx.Store(sum + i, Avx.Max(least, Avx.Min(most, Avx.Add(Avx.LoadVector256(a + i), Avx.LoadVector256(b + i)))));
            }
#endif
            for (; i < count; i++)
                sum[i] = Math.Max(low, Math.Min(high, a[i] + b[i]));
        }
    }
}
