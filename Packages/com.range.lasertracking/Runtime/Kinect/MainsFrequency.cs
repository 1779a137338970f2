namespace LaserTracking.Kinect
{
    /// <summary>Selects the ladder of exposures; the values are the camera's.</summary>
    public enum MainsFrequency
    {
        /// <summary>Exposures of 10 and 20 ms: whole periods of lamps at 50 Hz.</summary>
        Hz50 = 1,

        /// <summary>Exposures of 8.33 and 16.67 ms: whole periods of lamps, and of most projectors, at 60 Hz.</summary>
        Hz60 = 2,
    }
}
