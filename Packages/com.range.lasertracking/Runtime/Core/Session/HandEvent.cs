using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Session
{
    /// <summary>One hand in one frame of camera 1: the "hand" line of events.jsonl. Screen space, metres.</summary>
    public struct HandEvent
    {
        public int FrameIndex;
        public long TimeUs;
        public int TrackId;
        public HandSide Side;
        public Vector3D PalmM;

        /// <summary>Standard deviation of the palm along one axis; 0: the palm is not seen, or may be another's, and <see cref="PalmM"/> is a guess.</summary>
        public double PalmSigmaM;

        public Vector3D MuzzleM;
        public DepthSource DepthSource;
    }
}
