namespace LaserTracking.Detection
{
    /// <summary>A candidate that its frame does not decide, until all of the frame's candidates are known.</summary>
    internal readonly struct WaitingCandidate
    {
        public readonly Candidate Candidate;

        /// <summary>Its place in the trace; -1: none.</summary>
        public readonly int TraceIndex;

        public WaitingCandidate(in Candidate candidate, int traceIndex)
        {
            Candidate = candidate;
            TraceIndex = traceIndex;
        }
    }
}
