namespace LaserTracking.Detection
{
    /// <summary>One test that a candidate was put through: the measured value against the limit.</summary>
    public struct TestOutcome
    {
        /// <summary>What was measured, in a few words; explain.md says what each of them is.</summary>
        public string What;

        /// <summary>The reason of its rejection if it failed; None: decides only whether this frame alone suffices for a shot.</summary>
        public RejectionReason Reason;

        public bool IsPassed;

        public double Value;

        /// <summary>NaN: a plain condition, Value is 1 where it holds and 0 where not.</summary>
        public double Limit;

        /// <summary>The limit is the least value that passes; otherwise it is the largest.</summary>
        public bool IsMinimum;
    }
}
