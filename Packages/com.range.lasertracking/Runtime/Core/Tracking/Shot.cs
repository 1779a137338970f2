using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>One flash of one laser, however many frames it lasts. Pixel quantities as in <see cref="Dot"/>.</summary>
    public struct Shot
    {
        /// <summary>Counts from 1 in the order of reporting.</summary>
        public int Id;

        /// <summary>Frame in which it was reported.</summary>
        public int FrameIndex;

        /// <summary>First frame that shows its light.</summary>
        public int FirstFrameIndex;

        /// <summary>Last frame that shows its light as far as known at the time of reporting.</summary>
        public int LastFrameIndex;

        /// <summary>Mid-exposure of the first frame, microseconds on the device's clock.</summary>
        public long TimeUs;

        /// <summary>Standard deviation of the moment the light began, microseconds.</summary>
        public long TimeSigmaUs;

        /// <summary>The dot in its first frame.</summary>
        public Dot Dot;

        /// <summary>Track that goes on delivering this laser's dots while it stays lit.</summary>
        public int TrackId;
    }
}
