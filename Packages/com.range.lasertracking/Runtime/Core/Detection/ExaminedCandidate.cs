using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>A spot that the detector examined in one frame, in pixels of the whole picture (a pixel's centre has whole coordinates).</summary>
    public struct ExaminedCandidate
    {
        /// <summary>The pixel from which it grew.</summary>
        public Vector2D SeedPx;

        /// <summary>Centre of its area; the seed when it failed before it was grown.</summary>
        public Vector2D PositionPx;

        /// <summary>Its box, edges included; the seed alone when it failed before it was grown.</summary>
        public Vector2D TopLeftPx;
        public Vector2D BottomRightPx;

        /// <summary>Found in the smallest of the three channels (saturated light); otherwise in the largest (faint or coloured light).</summary>
        public bool IsSmallestChannel;

        /// <summary>Found because it is brighter than anything that the projected picture shows.</summary>
        public bool IsAboveContent;

        /// <summary>Largest rise above its own past: levels, and share of the room left there, 0…1.</summary>
        public double RiseLevels;
        public double Rise;

        /// <summary>It goes on from a dot of the frame before and need not prove itself again.</summary>
        public bool IsContinued;

        /// <summary>The light was not there in the frame before.</summary>
        public bool IsOnset;

        /// <summary>This frame alone suffices for a shot; otherwise the tracker waits.</summary>
        public bool IsConclusive;

        /// <summary>None: it is a dot, number <see cref="DotIndex"/> of the frame's detections.</summary>
        public RejectionReason Reason;
        public double Value;
        public double Limit;

        /// <summary>Index in <see cref="Detections.Dots"/>; -1: none.</summary>
        public int DotIndex;

        internal int FirstTest;
        internal int TestCount;
    }
}
