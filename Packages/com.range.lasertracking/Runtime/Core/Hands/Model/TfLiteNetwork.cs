using System;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Runs a <see cref="TfLiteModel"/> in float32. Weights are unpacked and all memory is taken when it is built; a run allocates
    /// nothing. One thread at a time.
    /// </summary>
    internal sealed unsafe class TfLiteNetwork : IDisposable
    {
        private readonly NetworkLayer[] _layers;
        private readonly FloatBuffer _activations;
        private readonly FeatureMap[] _inputs;
        private readonly FeatureMap[] _outputs;
        private readonly KernelRunner _kernels;
        private readonly bool _useVectors;

        /// <param name="model">What to run; not needed afterwards.</param>
        /// <param name="useVectors">See <see cref="HasVectors"/>.</param>
        /// <param name="kernels">What runs the operators; this thread when absent.</param>
        /// <exception cref="InputException">The operators do not fit together, or there are too many of them to run live.</exception>
        public TfLiteNetwork(TfLiteModel model, bool useVectors, KernelRunner? kernels = null)
        {
            _kernels = kernels ?? KernelRunner.Plain;
            var builder = new NetworkBuilder(model, _kernels.BandCount);
            _layers = builder.Build(out _activations);
            _inputs = Array.ConvertAll(model.Inputs, builder.Map);
            _outputs = Array.ConvertAll(model.Outputs, builder.Map);
            _useVectors = useVectors;
        }

        /// <summary>The processor has the vectors that the fast kernels need (AVX with fused multiply-add).</summary>
        public static bool HasVectors
        {
            get
            {
#if NET8_0_OR_GREATER
                return System.Runtime.Intrinsics.X86.Fma.IsSupported;
#else
                return false;
#endif
            }
        }

        /// <summary>Written before a run; kept by it.</summary>
        public ReadOnlySpan<FeatureMap> Inputs => _inputs;

        /// <summary>In the file's order; valid until the next run.</summary>
        public ReadOnlySpan<FeatureMap> Outputs => _outputs;

        public void Run()
        {
            foreach (NetworkLayer layer in _layers)
                layer.Run(_kernels, _useVectors);
        }

        public void Dispose()
        {
            foreach (NetworkLayer layer in _layers)
                (layer as IDisposable)?.Dispose();
            _activations.Dispose();
        }
    }
}
