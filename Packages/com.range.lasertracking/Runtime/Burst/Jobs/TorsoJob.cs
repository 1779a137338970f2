using LaserTracking.Hands;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The body in a surface, and what stands out before it. See <see cref="TorsoBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct TorsoJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public TorsoBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
