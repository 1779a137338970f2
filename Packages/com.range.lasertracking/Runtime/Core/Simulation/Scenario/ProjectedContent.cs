namespace LaserTracking.Simulation
{
    /// <summary>What the projector shows behind the scene's targets.</summary>
    public enum ProjectedContent
    {
        /// <summary>A shooting bay that stands still.</summary>
        Bay = 0,

        /// <summary>A plain grey with six large shapes that move all over the picture.</summary>
        Shapes = 1,

        /// <summary>The same shapes over a texture that scrolls: every pixel changes all the time.</summary>
        ShapesOverTexture = 2,

        /// <summary>The pictures of the screen's calibration, one after the other.</summary>
        Calibration = 3,
    }
}
