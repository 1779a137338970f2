using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>Who fired a shot, from where, along which line. Screen space: metres, x right, y down, z into the picture.</summary>
    public struct FusedShot
    {
        /// <summary>1-based in the order of first shots, or 0: unknown.</summary>
        public int Shooter;

        /// <summary>Probability of that, 0…1; 0 when unknown.</summary>
        public double ShooterProbability;

        /// <summary>Unknown unless the hand's own picture told it: of an arm in depth alone nobody can say which hand fires.</summary>
        public HandSide Hand;

        /// <summary>Track of that hand, or 0.</summary>
        public int HandTrackId;

        /// <summary>False without a paired hand; then what follows means nothing.</summary>
        public bool HasMuzzle;

        public Vector3D MuzzleM;

        /// <summary>Standard deviation of the muzzle along one axis, the distance in time included.</summary>
        public double MuzzleSigmaM;

        /// <summary>d̂ = v / (|v| + ε), v from the muzzle to the dot.</summary>
        public Vector3D Direction;

        /// <summary>Angle between the arm's axis and v, radians; NaN when the axis is unknown.</summary>
        public double AimErrorRad;

        /// <summary>
        /// Angle between the line from the eyes over the muzzle and v, radians, longer where that line is known better than on average; NaN when
        /// no head is seen.
        /// </summary>
        public double SightErrorRad;

        /// <summary>Time of the hand minus time of the shot, microseconds.</summary>
        public long PairDeltaUs;
    }
}
