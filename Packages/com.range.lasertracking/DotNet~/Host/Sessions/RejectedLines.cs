namespace LaserTracking.Host.Sessions
{
    /// <summary>Which rejected candidates are written among the events.</summary>
    internal enum RejectedLines
    {
        All,

        /// <summary>Without those that every moving edge makes by the hundred.</summary>
        Notable,

        None,
    }
}
