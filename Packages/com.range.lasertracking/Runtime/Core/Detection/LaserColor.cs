namespace LaserTracking.Detection
{
    /// <summary>Colour of a laser; Unknown rather than a guess.</summary>
    public enum LaserColor : byte
    {
        Unknown = 0,
        Green = 1,
        Red = 2,
        Infrared = 3,
    }
}
