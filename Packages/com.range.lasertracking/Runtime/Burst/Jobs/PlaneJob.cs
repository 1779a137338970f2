using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Working picture, envelopes and tiles of the default detector. See <see cref="PlaneBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct PlaneJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public PlaneBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
