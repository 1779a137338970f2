namespace LaserTracking.Detection
{
    /// <summary>One test that a candidate was put through: the measured value against the limit.</summary>
    public struct TestOutcome
    {
        /// <summary>What was measured, in words, with its unit.</summary>
        public string What;

        /// <summary>The reason of its rejection if it failed; None: decides only whether this frame alone suffices for a shot.</summary>
        public RejectionReason Reason;

        public bool IsPassed;

        public double Value;

        public double Limit;

        /// <summary>The limit is the least value that passes; otherwise it is the largest.</summary>
        public bool IsMinimum;
    }
}
