using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A bright spot as one window shows it; pixels and units of the picture it was read from.</summary>
    internal struct Spot
    {
        /// <summary>Centroid of the light above its surroundings, soft threshold of a fifth of the height.</summary>
        public Vector2D PositionPx;
        public Covariance2D CovariancePx;

        /// <summary>Median of the window's border.</summary>
        public int Background;

        /// <summary>Spread of the window's border as one standard deviation.</summary>
        public double Sigma;

        /// <summary>Height of the brightest pixel over the background.</summary>
        public int Rise;

        /// <summary>Light of the brightest pixel and its eight neighbours over what lies four pixels away: stands out of noise where a pixel does not.</summary>
        public int CoreLight;

        /// <summary>Pixels of half the height or more, connected to the brightest.</summary>
        public int Area;

        /// <summary>Pixels among the brightest and its eight neighbours that reach a fifth of the height: 1 for a defective pixel.</summary>
        public int Foot;
        public int Left;
        public int Top;
        public int Right;
        public int Bottom;

        /// <summary>The half-height area reaches the window's border: it is larger than a spot.</summary>
        public bool IsCut;

        /// <summary>Length through width of the half-height area.</summary>
        public double Elongation;

        /// <summary>Share of the ring around the area that reaches half the height.</summary>
        public double RingShare;
    }
}
