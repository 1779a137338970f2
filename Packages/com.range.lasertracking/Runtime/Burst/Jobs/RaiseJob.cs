using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The brightest of several rendered pictures. See <see cref="RaiseBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct RaiseJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public RaiseBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
