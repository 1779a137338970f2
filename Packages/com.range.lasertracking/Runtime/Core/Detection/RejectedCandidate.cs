using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A candidate that was not a shot, with the test that it failed: the measured value and the limit it missed.</summary>
    public struct RejectedCandidate
    {
        public Vector2D PositionPx;
        public RejectionReason Reason;
        public double Value;
        public double Limit;
    }
}
