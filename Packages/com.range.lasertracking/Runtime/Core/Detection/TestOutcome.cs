namespace LaserTracking.Detection
{
    /// <summary>One test that a candidate was put through: the measured value against the limit; or what a value says for or against a dot.</summary>
    public struct TestOutcome
    {
        /// <summary>What was measured, in a few words; explain.md says what each of them is.</summary>
        public string What;

        /// <summary>The reason of its rejection if it failed; None: decides only whether this frame alone suffices for a shot.</summary>
        public RejectionReason Reason;

        public bool IsPassed;

        public double Value;

        /// <summary>NaN: a plain condition, Value is 1 where it holds and 0 where not; or evidence, which has no limit.</summary>
        public double Limit;

        /// <summary>The limit is the least value that passes; otherwise it is the largest.</summary>
        public bool IsMinimum;

        /// <summary>What the value says for (positive) or against a dot, log-odds; NaN: an ordinary test. Evidence never fails alone, its sum does.</summary>
        public double LogOdds;

        public readonly bool IsEvidence => !double.IsNaN(LogOdds);
    }
}
