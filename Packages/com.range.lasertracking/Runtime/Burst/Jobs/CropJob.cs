using LaserTracking.Hands.Model;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>The square of a picture that the hand model looks at. See <see cref="CropBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct CropJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public CropBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
