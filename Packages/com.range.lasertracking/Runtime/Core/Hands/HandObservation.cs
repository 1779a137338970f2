using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>One hand in one frame of camera 1. Camera space of that camera: x right, y down, z forward, mm.</summary>
    public struct HandObservation
    {
        /// <summary>Stays with one hand from frame to frame; a new number after it was lost for long.</summary>
        public int TrackId;

        public HandSide Side;
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

        public DepthSource DepthSource;
    }
}
