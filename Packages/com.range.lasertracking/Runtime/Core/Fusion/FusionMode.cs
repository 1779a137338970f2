namespace LaserTracking.Fusion
{
    /// <summary>How a shot finds its hand.</summary>
    public enum FusionMode : byte
    {
        /// <summary>By arm axis, place, colour and time among all hands, with a probability, and "nobody" as an answer.</summary>
        Assigned = 0,

        /// <summary>The published rule: one user; the hand nearest in time within the window, as it was then.</summary>
        Published = 1,
    }
}
