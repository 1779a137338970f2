using LaserTracking.Hands.Model;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Depthwise convolutions of the hand model. See <see cref="DepthwiseBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct DepthwiseJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public DepthwiseBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
