using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>What a shot met in the scene as it stood when the light left.</summary>
    public struct ScoredHit
    {
        /// <summary>Name of the target.</summary>
        public string Target;

        /// <summary>Name of the zone.</summary>
        public string Zone;

        /// <summary>The zone's points.</summary>
        public int Points;

        /// <summary>Points weighed by the scoring rule.</summary>
        public double Score;

        /// <summary>Scene space, metres.</summary>
        public Vector3D PointM;

        /// <summary>In the target's plane: metres, x right, y up, from its centre.</summary>
        public Vector2D LocalPointM;

        /// <summary>From the ray's origin behind the screen to the point.</summary>
        public double DistanceM;

        /// <summary>Probability that the true point lies in the same zone, given the shot's uncertainty.</summary>
        public double ZoneProbability;
    }
}
