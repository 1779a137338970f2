namespace LaserTracking.Unity
{
    /// <summary>How far a <see cref="CalibrationScreen"/> has come.</summary>
    public enum CalibrationState
    {
        Idle = 0,

        /// <summary>The patterns are on the screen and the camera looks at them.</summary>
        Showing = 1,

        /// <summary>What it saw is being worked at, in the background.</summary>
        Computing = 2,

        /// <summary>The calibration holds; it is stored and in use. The error map is shown.</summary>
        Accepted = 3,

        /// <summary>It does not hold; the old one stays. The error map and the reason are shown.</summary>
        Refused = 4,
    }
}
