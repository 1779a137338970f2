using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>One hand in one frame of camera 1. Camera space of that camera: x right, y down, z forward, mm.</summary>
    public struct HandObservation
    {
        /// <summary>Stays with one hand from frame to frame; a new number after it was lost for long.</summary>
        public int TrackId;

        /// <summary>Whose hand it is, or 0 when no head is seen over its arm.</summary>
        public int PersonId;

        public HandSide Side;

        /// <summary>
        /// The hand's own picture tells the side (hand model), not only where its arm begins: bodies turn sideways, and of two hands on one
        /// weapon the supporting arm may be the one in sight.
        /// </summary>
        public bool IsSideSure;
        public Vector3D PalmMm;

        /// <summary>Where the light leaves the weapon: the foremost point along the arm.</summary>
        public Vector3D MuzzleMm;

        /// <summary>Unit vector from the forearm through the palm; zero when unknown.</summary>
        public Vector3D AimDirection;

        /// <summary>Standard deviation of the palm along one axis.</summary>
        public double SigmaMm;

        /// <summary>Standard deviation of the muzzle along one axis.</summary>
        public double MuzzleSigmaMm;

        /// <summary>Standard deviation of <see cref="AimDirection"/> about one axis, radians; means nothing when that is zero.</summary>
        public double AimSigmaRad;

        /// <summary>
        /// Unit vector from about where the eyes are to the muzzle; zero when no head is seen. Somebody who aims over the weapon
        /// fires along it, while the arm comes from the shoulder, 10 to 30 degrees aside.
        /// </summary>
        public Vector3D SightDirection;

        /// <summary>Standard deviation of <see cref="SightDirection"/> about one axis, radians.</summary>
        public double SightSigmaRad;

        /// <summary>
        /// Unit vector along the weapon to its front, from its own picture; zero when it is not seen. Its bearing tells whose it is where arms
        /// cross; it is known to 0.1 to 0.2 rad and hangs down by the grip.
        /// </summary>
        public Vector3D WeaponDirection;

        public DepthSource DepthSource;
    }
}
