#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal sealed partial class TileGrid
    {
        /// <summary>Whole tiles; returns how many are done. 0 where the processor lacks SSE4.1.</summary>
        private static unsafe int ReduceRowVector(byte* columns, int width, byte* onsets)
        {
            if (!Sse41.IsSupported)
                return 0;
            int whole = width / Size;
            for (int t = 0; t < whole; t++)
                onsets[t] = LevelVectors.Largest(Sse2.LoadVector128(columns + t * Size));
            return whole;
        }
    }
}
#endif
