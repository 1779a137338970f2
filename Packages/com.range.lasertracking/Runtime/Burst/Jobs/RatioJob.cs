using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>How much brighter they have become. See <see cref="RatioBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct RatioJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public RatioBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
