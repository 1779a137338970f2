namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>What lies behind painted spots: level 25, level 150, or a pattern of stripes and steps between 20 and 110.</summary>
    internal enum SpotBackground
    {
        Dark,
        Bright,
        Textured,
    }
}
