using LaserTracking.Hands.Model;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Sums of the hand model. See <see cref="AddBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct AddJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public AddBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
