using LaserTracking.Hands;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Holes of that grid bridged. See <see cref="BridgeBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct BridgeJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public BridgeBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
