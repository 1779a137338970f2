namespace LaserTracking.Hands.Model
{
    /// <summary>One operator with its tensors in place. The network owns the memory that the layers point to.</summary>
    internal abstract class NetworkLayer
    {
        /// <param name="useVectors">Needs fused multiply-add; false: the scalar form, which is also the one for Burst.</param>
        public abstract void Run(bool useVectors);
    }
}
