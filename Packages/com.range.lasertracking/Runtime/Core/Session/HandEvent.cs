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
        public Vector3D MuzzleM;
        public DepthSource DepthSource;
    }
}
