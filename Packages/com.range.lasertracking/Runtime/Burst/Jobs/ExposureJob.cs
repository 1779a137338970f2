using LaserTracking.Hands.Model;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Infrared in that square made grey. See <see cref="ExposureBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct ExposureJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public ExposureBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
