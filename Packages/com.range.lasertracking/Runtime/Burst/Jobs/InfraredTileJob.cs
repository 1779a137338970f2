using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Tiles of an infrared picture. See <see cref="InfraredTileBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct InfraredTileJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public InfraredTileBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
