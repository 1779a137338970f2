using System;

namespace LaserTracking.Detection
{
    /// <summary>How much room an ordinary dot needs above its background: the detector's own limits, turned round.</summary>
    internal static class DotRoom
    {
        /// <summary>Area at half height of an ordinary dot, px² at 640: the median of real ones is larger.</summary>
        private const double OrdinaryAreaPx = 25;

        /// <summary>Least rise of an ordinary dot that the detector takes, levels, where nothing moves.</summary>
        /// <param name="settings">The detector's.</param>
        /// <param name="noise">Temporal noise, levels (one standard deviation).</param>
        public static double LeastRiseLevels(ShotDetectorSettings settings, double noise) =>
            Math.Max(Math.Max(settings.MinRiseLevels, settings.MinRiseSigmas * noise),
                Math.Max(LeastStrength(settings.Evidence) / Math.Sqrt(OrdinaryAreaPx), LeastOnsetLevels(0)));

        /// <summary>What a tile with this recent ordinary onset takes besides, levels.</summary>
        public static double LeastOnsetLevels(double activity) => ShotDetector.GateFloor + TileGrid.GateShare * activity;

        /// <summary>Rise times root of the area from which strength speaks for a dot, levels·px.</summary>
        private static double LeastStrength(DotEvidence evidence) => Math.Exp(evidence.Curves[(int)DotFeature.LogStrength].NearestLimit(0));
    }
}
