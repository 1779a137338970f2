namespace LaserTracking.Host.Explanations
{
    /// <summary>What became of a candidate, as far as the frames that follow tell.</summary>
    internal enum CandidateState
    {
        Rejected,

        /// <summary>A dot that the tracker gave up later, or about which it has not decided.</summary>
        Waiting,

        /// <summary>Belongs to a flash that was reported in another frame.</summary>
        Dot,

        /// <summary>Reported as a shot in this frame or, after waiting, in a later one.</summary>
        Shot,
    }
}
