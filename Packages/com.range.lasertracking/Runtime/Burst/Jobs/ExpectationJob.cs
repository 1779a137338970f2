using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Rendered pictures as the camera would show them. See <see cref="ExpectationBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct ExpectationJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public ExpectationBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
