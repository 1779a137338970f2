namespace LaserTracking.Host.Explanations
{
    /// <summary>What the rows of a candidate's table decide.</summary>
    internal enum TestSection
    {
        /// <summary>Each must be passed.</summary>
        Tests,

        /// <summary>What each measure says; only the sum must reach a limit.</summary>
        Evidence,

        /// <summary>Whether this frame alone suffices for a shot.</summary>
        OneFrame,
    }
}
