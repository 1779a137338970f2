namespace LaserTracking.Remote
{
    /// <summary>What is remembered of one sender.</summary>
    internal sealed class SenderRecord
    {
        public SenderRecord(int packetsPerSecond)
        {
            Rate = new RateWindow(packetsPerSecond);
        }

        public bool IsUsed;

        /// <summary>Its stream, or for published messages without one a number made of its address.</summary>
        public long Identity;
        public bool HasStream;
        public long LastUs;
        public RateWindow Rate;
        public CounterWindow Packets;
        public CounterWindow Shots;

        public void Begin(long identity, bool hasStream)
        {
            IsUsed = true;
            Identity = identity;
            HasStream = hasStream;
            Rate.Clear();
            Packets = default;
            Shots = default;
        }
    }
}
