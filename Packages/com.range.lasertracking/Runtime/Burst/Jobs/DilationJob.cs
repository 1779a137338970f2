using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The past widened by a pixel, while the camera shakes. See <see cref="DilationBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct DilationJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public DilationBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
