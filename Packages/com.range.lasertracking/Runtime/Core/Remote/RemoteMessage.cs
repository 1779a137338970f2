namespace LaserTracking.Remote
{
    /// <summary>What one packet says.</summary>
    internal struct RemoteMessage
    {
        public bool IsShot;
        public bool IsPose;

        /// <summary>It says who sent it, when, and as which of its packets; without that the next three mean nothing.</summary>
        public bool HasHead;

        /// <summary>Random number of the sender's run, 1…2^53.</summary>
        public long Stream;

        /// <summary>Grows with every packet of the stream, from 1.</summary>
        public long Counter;

        /// <summary>Sender's wall clock, microseconds since 1970-01-01 UTC.</summary>
        public long SentUs;

        /// <summary>Both for a published shot.</summary>
        public RemotePose Pose;
        public RemoteShot Shot;
    }
}
