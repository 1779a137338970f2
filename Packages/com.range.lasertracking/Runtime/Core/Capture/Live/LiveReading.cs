namespace LaserTracking.Capture.Live
{
    /// <summary>What came of waiting for a live camera's next picture.</summary>
    public enum LiveReading : byte
    {
        /// <summary>A picture; the frame holds it.</summary>
        Picture = 0,

        /// <summary>None in the time given, or one that cannot be used; the camera may still be well.</summary>
        Nothing = 1,

        /// <summary>The camera is gone, or its library gave up: close it and look for it again.</summary>
        Lost = 2,
    }
}
