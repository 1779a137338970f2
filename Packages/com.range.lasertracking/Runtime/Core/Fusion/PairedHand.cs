using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>A hand at the moment of a shot.</summary>
    public struct PairedHand
    {
        /// <summary>Between the sightings around the moment, or the nearest one as it was.</summary>
        public HandObservation Hand;

        /// <summary>Time of the nearest sighting minus that of the shot, microseconds.</summary>
        public long DeltaUs;

        public bool IsInterpolated;

        /// <summary>Of the muzzle, camera space, over the last sightings.</summary>
        public Vector3D MuzzleVelocityMmS;

        /// <summary>Time over which that was measured, seconds; 0: it is unknown.</summary>
        public double VelocitySeconds;
    }
}
