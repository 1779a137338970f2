namespace LaserTracking.Detection
{
    /// <summary>How far the expected view of the projected picture can be relied on.</summary>
    public enum PredictionState : byte
    {
        /// <summary>No rendered pictures are given.</summary>
        Off = 0,

        /// <summary>The delay between drawing and seeing is not known: nothing has moved yet, or the pictures do not fit.</summary>
        Searching = 1,

        /// <summary>The delay is known, how the camera sees the projector's colours not well enough yet.</summary>
        Learning = 2,

        /// <summary>What exceeds the expected view is light from elsewhere.</summary>
        Trusted = 3,

        /// <summary>The delay is known, but too much of what the camera sees is not as expected.</summary>
        Doubtful = 4,
    }
}
