using System;

namespace LaserTracking.Detection
{
    /// <summary>Counts what an action allocates on this thread. The counter's own first call allocates, so it is made beforehand.</summary>
    internal static class Allocation
    {
        public static long Of(Action action)
        {
            action();
            GC.GetAllocatedBytesForCurrentThread();
            long before = GC.GetAllocatedBytesForCurrentThread();
            action();
            return GC.GetAllocatedBytesForCurrentThread() - before;
        }
    }
}
