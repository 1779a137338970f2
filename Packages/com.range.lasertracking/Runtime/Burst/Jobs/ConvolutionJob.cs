using LaserTracking.Hands.Model;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Convolutions and fully connected layers of the hand model. See <see cref="ConvolutionBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct ConvolutionJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public ConvolutionBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
