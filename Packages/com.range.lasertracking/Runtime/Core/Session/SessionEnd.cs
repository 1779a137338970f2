namespace LaserTracking.Session
{
    /// <summary>The "end" line of events.jsonl.</summary>
    public struct SessionEnd
    {
        /// <summary>Frames of camera 0 that were processed.</summary>
        public int Frames;

        /// <summary>Frames without a usable picture.</summary>
        public int Dropped;

        /// <summary>From the first to the last frame on the recording's clock.</summary>
        public double SecondsMedia;

        /// <summary>By the host's clock; the only value that differs between two runs. A session's replay repeats the recorded one.</summary>
        public double SecondsWall;

        /// <summary>Time of the first frame, microseconds on the recording's clock: where a report's seconds begin; null when not known.</summary>
        public long? StartTimeUs;
    }
}
