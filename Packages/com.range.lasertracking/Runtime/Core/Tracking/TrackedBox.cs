namespace LaserTracking.Tracking
{
    /// <summary>A box of the current frame and the track it belongs to.</summary>
    public readonly struct TrackedBox
    {
        public TrackedBox(int trackId, in BoundingBox box)
        {
            TrackId = trackId;
            Box = box;
        }

        /// <summary>Counts from 1 in the order of first sight.</summary>
        public int TrackId { get; }

        public BoundingBox Box { get; }
    }
}
