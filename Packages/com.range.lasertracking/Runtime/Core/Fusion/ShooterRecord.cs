using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>What is remembered of one shooter.</summary>
    internal struct ShooterRecord
    {
        /// <summary>Who it is among those seen: a person, or minus the track of a hand.</summary>
        public int Key;

        /// <summary>Where they last stood: their eyes, screen space; null where only a hand is known.</summary>
        public Vector3D? EyesM;

        /// <summary>Where their muzzle was last seen, screen space; null: never.</summary>
        public Vector3D? MuzzleM;

        public long SeenUs;

        public ColorTally Colors;
    }
}
