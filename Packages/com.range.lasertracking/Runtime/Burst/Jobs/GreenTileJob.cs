using LaserTracking.Detection;
using Unity.Burst;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>Tiles of green excess of a colour picture. See <see cref="GreenTileBands"/>.</summary>
    [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
    internal unsafe struct GreenTileJob : IJobFor
    {
        [NativeDisableUnsafePtrRestriction]
        public GreenTileBands* Work;

        public void Execute(int band) => Work->Execute(band);
    }
}
