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
    }
}
