namespace LaserTracking.Detection
{
    /// <summary>What a colour camera makes of laser light.</summary>
    public static class LaserResponse
    {
        /// <summary>
        /// Signal of one watt per m² of monochromatic light in red, green and blue relative to the same of projected white, which
        /// spreads over three channels: a colour filter passes one of them and leaks a tenth of its neighbours'.
        /// </summary>
        public static void Of(LaserColor color, out float red, out float green, out float blue)
        {
            switch (color)
            {
                case LaserColor.Red:
                    red = 2.3f;
                    green = 0.2f;
                    blue = 0.1f;
                    break;
                case LaserColor.Infrared:
                    red = 0.05f;
                    green = 0.03f;
                    blue = 0.045f;
                    break;
                default:
                    red = 0.3f;
                    green = 2.7f;
                    blue = 0.42f;
                    break;
            }
        }
    }
}
