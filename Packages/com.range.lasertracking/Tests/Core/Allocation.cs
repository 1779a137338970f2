using System;

namespace LaserTracking
{
    /// <summary>
    /// Counts what warm code allocates on this thread: the least of some rounds. What the code itself allocates it allocates in every
    /// round; what the runtime allocates while it compiles a hot method anew it does not.
    /// </summary>
    internal static class Allocation
    {
        private const int Rounds = 6;

        /// <param name="round">Repeatable work; its first run warms it up.</param>
        public static long Of(Action round)
        {
            round();
            long least = long.MaxValue;
            for (int i = 0; i < Rounds; i++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                round();
                least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
            }

            return least;
        }
    }
}
