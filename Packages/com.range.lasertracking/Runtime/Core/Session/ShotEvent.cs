using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Tracking;

namespace LaserTracking.Session
{
    /// <summary>Everything known of one shot when it is reported: the "shot" line of events.jsonl.</summary>
    public struct ShotEvent
    {
        public Shot Shot;

        /// <summary>False without a screen calibration; then the next two mean nothing.</summary>
        public bool HasScreenPosition;

        /// <summary>Screen space: metres from the top-left corner, x right, y down.</summary>
        public Vector2D ScreenM;

        public Covariance2D ScreenCovarianceMm2;

        /// <summary>1-based number of the shooter, or 0: unknown.</summary>
        public int Shooter;

        /// <summary>Probability of that, 0…1; 0 when unknown.</summary>
        public double ShooterProbability;

        public HandSide Hand;

        /// <summary>False without a paired hand; then muzzle, direction and pair time mean nothing.</summary>
        public bool HasMuzzle;

        /// <summary>Screen space, metres (z negative: in front of the screen).</summary>
        public Vector3D MuzzleM;

        /// <summary>Unit vector from the muzzle to the dot, screen space.</summary>
        public Vector3D Direction;

        /// <summary>Time of the hand minus time of the shot, microseconds.</summary>
        public long PairDeltaUs;

        /// <summary>False when the ray met no target.</summary>
        public bool HasHit;

        public ScoredHit Hit;
    }
}
