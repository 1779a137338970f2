namespace LaserTracking.Detection
{
    /// <summary>What is caught in one part of the screen.</summary>
    public readonly struct RegionAdvice
    {
        public RegionAdvice(double dimmestMw, double dimmestLevels, double shortestMs, double backgroundLevel)
        {
            DimmestMw = dimmestMw;
            DimmestLevels = dimmestLevels;
            ShortestMs = shortestMs;
            BackgroundLevel = backgroundLevel;
        }

        /// <summary>Least power of a dot lit for a whole exposure, mW; NaN: none is caught.</summary>
        public double DimmestMw { get; }

        /// <summary>How far that dot's strongest channel rises, levels; NaN as above.</summary>
        public double DimmestLevels { get; }

        /// <summary>Shortest flash of the laser asked about, ms; NaN: none up to 300 ms is caught.</summary>
        public double ShortestMs { get; }

        /// <summary>The background's mean strongest channel, levels.</summary>
        public double BackgroundLevel { get; }
    }
}
