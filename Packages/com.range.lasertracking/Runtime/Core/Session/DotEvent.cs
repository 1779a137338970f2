using LaserTracking.Detection;

namespace LaserTracking.Session
{
    /// <summary>One tracked dot in one frame: the "dot" line of events.jsonl.</summary>
    public struct DotEvent
    {
        public int FrameIndex;
        public long TimeUs;
        public int TrackId;
        public Dot Dot;

        /// <summary>1-based number of the shooter, or 0: unknown.</summary>
        public int Shooter;
    }
}
