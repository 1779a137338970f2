namespace LaserTracking.Editor
{
    /// <summary>How one part of a set-up stands.</summary>
    public enum SetupState
    {
        /// <summary>There and in order.</summary>
        Active = 0,

        /// <summary>Not there; only who wants it needs it.</summary>
        Asleep = 1,

        /// <summary>The range works, but less well.</summary>
        Advised = 2,

        /// <summary>Without it there are no hits.</summary>
        Missing = 3,
    }
}
