using LaserTracking.Hands;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>A depth picture gathered into cells. See <see cref="DepthGridBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct DepthGridJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public DepthGridBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
