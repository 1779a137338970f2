namespace LaserTracking.Detection
{
    /// <summary>What the colour picture says of a spot.</summary>
    internal enum LightHue : byte
    {
        /// <summary>No spot of light there.</summary>
        None,

        /// <summary>There is light, but the background leaves no room to tell its colour.</summary>
        Unknown,

        Green,

        /// <summary>Red and blue above green: how a colour camera sees near infrared.</summary>
        Magenta,

        White,

        /// <summary>Red, yellow, blue, cyan.</summary>
        Other,
    }
}
