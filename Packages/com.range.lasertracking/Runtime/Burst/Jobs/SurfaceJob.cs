using LaserTracking.Hands;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The next connected surface of the grid. See <see cref="SurfaceBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct SurfaceJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public SurfaceBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
