namespace LaserTracking.Session
{
    /// <summary>Something the operator should know: the "health" line of events.jsonl.</summary>
    public struct HealthEvent
    {
        public int FrameIndex;
        public long TimeUs;
        public HealthKind Kind;
        public double Value;

        /// <summary>One line for people: what it is and what to do.</summary>
        public string Text;
    }
}
