using System;
using LaserTracking.Remote;

namespace LaserTracking.Host.Remote
{
    /// <summary>The machine's clock.</summary>
    internal sealed class WallClock : IClock
    {
        public long NowUs => (DateTime.UtcNow - DateTime.UnixEpoch).Ticks / TimeSpan.TicksPerMicrosecond;
    }
}
