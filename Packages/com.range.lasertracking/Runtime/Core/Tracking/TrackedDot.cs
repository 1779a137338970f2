using LaserTracking.Detection;

namespace LaserTracking.Tracking
{
    /// <summary>One dot of the current frame and the track it belongs to: the same number as long as the same laser is followed.</summary>
    public readonly struct TrackedDot
    {
        public TrackedDot(int trackId, in Dot dot)
        {
            TrackId = trackId;
            Dot = dot;
        }

        /// <summary>Counts from 1 in the order of first sight.</summary>
        public int TrackId { get; }

        public Dot Dot { get; }
    }
}
