using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>One operator with its tensors in place. The network owns the memory that the layers point to.</summary>
    internal abstract class NetworkLayer
    {
        /// <param name="kernels">What runs it; of as many bands as the layer was built for.</param>
        /// <param name="useVectors">Needs fused multiply-add; false: the scalar form, which is also the one for Burst.</param>
        public abstract void Run(KernelRunner kernels, bool useVectors);
    }
}
