using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>One corner of a projected board, as a camera sees it.</summary>
    public readonly struct ScreenPoint
    {
        public ScreenPoint(Vector2D place, ScreenPointState state, Vector2D imagePx, double contrast, double symmetry, double blurPx)
        {
            Place = place;
            State = state;
            ImagePx = imagePx;
            Contrast = contrast;
            Symmetry = symmetry;
            BlurPx = blurPx;
        }

        /// <summary>Where it was projected: shares of the picture's width and height, from its top-left corner.</summary>
        public Vector2D Place { get; }

        public ScreenPointState State { get; }

        /// <summary>Where the camera sees it; where it would have to be, unless it was measured.</summary>
        public Vector2D ImagePx { get; }

        /// <summary>Half of the difference between white and black there, levels.</summary>
        public double Contrast { get; }

        /// <summary>Share of the light around it that half a turn leaves as it is: 1 but for noise, unless something is in the way.</summary>
        public double Symmetry { get; }

        /// <summary>Standard deviation of the edges' blur, px; 0 unless measured.</summary>
        public double BlurPx { get; }
    }
}
