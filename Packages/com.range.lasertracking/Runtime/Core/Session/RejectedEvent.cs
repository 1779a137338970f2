using LaserTracking.Detection;

namespace LaserTracking.Session
{
    /// <summary>A candidate that was not a shot: the "rejected" line of events.jsonl.</summary>
    public struct RejectedEvent
    {
        public int FrameIndex;
        public long TimeUs;
        public RejectedCandidate Candidate;
    }
}
