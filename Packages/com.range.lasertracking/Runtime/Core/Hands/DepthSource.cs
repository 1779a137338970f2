namespace LaserTracking.Hands
{
    /// <summary>How a hand's distance was come by.</summary>
    public enum DepthSource : byte
    {
        /// <summary>Median of depth pixels in the palm.</summary>
        Measured = 0,

        /// <summary>The palm's own pixels were missing; taken from the arm or from the moments before.</summary>
        Bridged = 1,

        /// <summary>The published fallback of a fixed distance.</summary>
        Assumed = 2,
    }
}
