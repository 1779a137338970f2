using System.Diagnostics;

namespace LaserTracking.Unity
{
    /// <summary>The clock that all live cameras share: microseconds since some moment, never back. From any thread.</summary>
    public static class HostClock
    {
        public static long NowUs()
        {
            long ticks = Stopwatch.GetTimestamp(), perSecond = Stopwatch.Frequency;
            return ticks / perSecond * 1_000_000 + ticks % perSecond * 1_000_000 / perSecond;
        }
    }
}
