using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Float pictures of the published algorithm. See <see cref="PaperBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct PaperJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public PaperBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
