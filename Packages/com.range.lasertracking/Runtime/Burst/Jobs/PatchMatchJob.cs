using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Where their content has gone. See <see cref="PatchMatchBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct PatchMatchJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public PatchMatchBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
