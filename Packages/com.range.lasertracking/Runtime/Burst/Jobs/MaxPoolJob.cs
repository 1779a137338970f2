using LaserTracking.Hands.Model;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Maxima under a window of the hand model. See <see cref="MaxPoolBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct MaxPoolJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public MaxPoolBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
