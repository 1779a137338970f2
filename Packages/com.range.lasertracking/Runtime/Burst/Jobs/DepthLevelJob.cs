using LaserTracking.Hands;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Cells with a depth marked. See <see cref="DepthLevelBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct DepthLevelJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public DepthLevelBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
