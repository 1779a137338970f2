using System;

namespace LaserTracking.Remote
{
    /// <summary>The machine's, for tests over the loopback.</summary>
    internal sealed class WallClock : IClock
    {
        public long NowUs => (DateTime.UtcNow - DateTime.UnixEpoch).Ticks / 10;
    }
}
