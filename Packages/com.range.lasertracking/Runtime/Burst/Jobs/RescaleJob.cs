using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The past made as bright as a new exposure. See <see cref="RescaleBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct RescaleJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public RescaleBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
