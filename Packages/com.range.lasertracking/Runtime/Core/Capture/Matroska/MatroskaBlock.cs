namespace LaserTracking.Capture.Matroska
{
    /// <summary>One block of one track: where its payload lies and when it was taken. The payload itself is not read.</summary>
    public struct MatroskaBlock
    {
        /// <summary>Offset of the block's element (SimpleBlock or BlockGroup).</summary>
        public long ElementOffset;

        /// <summary>First byte behind that element.</summary>
        public long ElementEnd;

        public long ClusterOffset;

        /// <summary>Number of the track that it belongs to.</summary>
        public long Track;

        /// <summary>Nanoseconds from the start of the recording.</summary>
        public long TimeNs;

        /// <summary>Nanoseconds; 0 when the file does not tell.</summary>
        public long DurationNs;

        /// <summary>First byte behind the block's own head: the lacing head, or the frame itself when there is no lacing.</summary>
        public long PayloadOffset;

        public int PayloadSize;

        public BlockLacingKind Lacing;

        /// <summary>The cluster's checksum does not fit: the payload may be damaged.</summary>
        public bool IsSuspect;
    }
}
