using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Relative rises in chosen tiles. See <see cref="RiseBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct RiseJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public RiseBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
