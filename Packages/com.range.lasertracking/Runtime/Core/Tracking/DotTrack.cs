using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>What is known of one flash: where and when it began, what was last seen, whether it has been reported.</summary>
    internal struct DotTrack
    {
        /// <summary>The laser's number, that of the last dot; 0: too many to tell apart.</summary>
        public int Id;

        public Dot First;
        public int FirstFrame;
        public long FirstTimeUs;

        /// <summary>Time from the frame before the first one; 0: there was none.</summary>
        public long FirstIntervalUs;

        public Vector2D LastPx;
        public Covariance2D LastShapePx;

        /// <summary>Of the last step; zero while only one dot has been seen, unless another light went out as this one began.</summary>
        public Vector2D VelocityPxPerUs;
        public int LastFrame;
        public long LastTimeUs;

        /// <summary>Dots of this flash so far.</summary>
        public int Count;

        public bool IsReported;

        /// <summary>It was lost while something moved at its place.</summary>
        public bool IsCovered;

        /// <summary>Matched in the frame being processed.</summary>
        public bool IsSeen;
    }
}
