using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Levels and changes on a sparse grid counted. See <see cref="HistogramBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct HistogramJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public HistogramBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
