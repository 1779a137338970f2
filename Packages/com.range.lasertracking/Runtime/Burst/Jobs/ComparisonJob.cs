using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The working picture against what is expected of it. See <see cref="ComparisonBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct ComparisonJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public ComparisonBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
