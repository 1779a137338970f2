using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Patches of the raw picture read and summed up. See <see cref="PatchBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct PatchJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public PatchBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
