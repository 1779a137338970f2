using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>The light of one pulse as one colour frame gathered it. Pixel centres are integers.</summary>
    public readonly struct TrueDot
    {
        internal TrueDot(int shotId, int frame, Vector2D positionPx, Vector2D firstPx, Vector2D lastPx, double lightUs, double peak)
        {
            ShotId = shotId;
            Frame = frame;
            PositionPx = positionPx;
            FirstPx = firstPx;
            LastPx = lastPx;
            LightUs = lightUs;
            Peak = peak;
        }

        public int ShotId { get; }

        /// <summary>Index of the frame as delivered.</summary>
        public int Frame { get; }

        /// <summary>Centroid of the light gathered, before the sensor clips and without speckle.</summary>
        public Vector2D PositionPx { get; }

        /// <summary>Where the dot was when this frame began to see it.</summary>
        public Vector2D FirstPx { get; }

        /// <summary>Where it was when this frame saw it last.</summary>
        public Vector2D LastPx { get; }

        public Vector2D StreakPx => LastPx - FirstPx;

        /// <summary>How long the light fell into this frame's exposure, µs.</summary>
        public double LightUs { get; }

        /// <summary>About how far the strongest channel rises at the dot's brightest pixel, linear; 1 = saturation.</summary>
        public double Peak { get; }
    }
}
