using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>Light of a laser as one frame shows it. Pixel centres are integers, x right, y down.</summary>
    public struct Dot
    {
        public Vector2D PositionPx;
        public Covariance2D CovariancePx;

        /// <summary>Second moments of the light above a fifth of its peak, px²: the dot's shape.</summary>
        public Covariance2D ShapePx;

        /// <summary>Brightest channel value in the dot, 0…255.</summary>
        public int Peak;

        /// <summary>Pixels at or above half the dot's height over its background.</summary>
        public int AreaPx;

        public LaserColor Color;

        /// <summary>Probability that this is a laser, 0…1: the sum of the factors. The published detector's is its own score.</summary>
        public double Confidence;

        public ConfidenceFactors Factors;

        /// <summary>From one end to the other of the light in this frame; zero for a round dot. Of a shot that a later frame told more of: from where it began.</summary>
        public Vector2D StreakPx;

        /// <summary>
        /// This frame alone suffices to call it a laser. A dot that is not conclusive counts once it vanishes sharply or comes again.
        /// </summary>
        public bool IsConclusive;

        /// <summary>The light was not there in the frame before.</summary>
        public bool IsOnset;

        /// <summary>
        /// It is no brighter than the projected picture can be, so growing does not prove it: things that come from behind others do.
        /// </summary>
        public bool MayBeContent;
    }
}
