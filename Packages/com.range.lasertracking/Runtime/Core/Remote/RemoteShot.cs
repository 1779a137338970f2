using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>A shot that a remote detector reported.</summary>
    public struct RemoteShot
    {
        /// <summary>
        /// As the sender knew it, but without its hit: what was hit is judged where the scene is. Of a published message only time
        /// and confidence.
        /// </summary>
        public ShotEvent Event;

        /// <summary>The ray of a published message, in camera 0's space; of our own message nothing that Event does not say.</summary>
        public RemotePose Aim;

        /// <summary>When it came here, microseconds, receiver's wall clock.</summary>
        public long ReceivedTimeUs;
    }
}
