#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics.X86;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    internal static unsafe partial class PatchKernel
    {
        private const int CacheLineBytes = 64;

        /// <summary>Asks memory for all rows of a patch at once: runs a picture's line apart are nothing that a processor foresees.</summary>
        private static void Announce(PictureView source, long first, int top, int factor, int bytes)
        {
            if (!Sse.IsSupported)
                return;
            for (int y = 0; y < Window; y++)
            {
                byte* row = source.Row((top + y) * factor) + first;
                for (int at = 0; at < bytes + CacheLineBytes; at += CacheLineBytes)
                    Sse.Prefetch0(row + at);
            }
        }
    }
}
#endif
