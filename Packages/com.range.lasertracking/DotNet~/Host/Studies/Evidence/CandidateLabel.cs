namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>What a candidate really was.</summary>
    internal enum CandidateLabel
    {
        NoDot,

        /// <summary>Light of a dot that was there before and grew.</summary>
        LaterDot,

        /// <summary>A dot in its first frame.</summary>
        FirstDot,
    }
}
