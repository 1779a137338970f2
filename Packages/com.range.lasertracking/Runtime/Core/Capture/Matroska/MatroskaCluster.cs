namespace LaserTracking.Capture.Matroska
{
    /// <summary>What is known of one cluster after a walk over its children's heads.</summary>
    internal struct MatroskaCluster
    {
        /// <summary>Offset of the cluster element.</summary>
        public long Offset;

        /// <summary>Offset of its first child.</summary>
        public long DataOffset;

        /// <summary>End of the children that are whole and lie inside the cluster.</summary>
        public long BlocksEnd;

        /// <summary>End by the declared size; -1 when that is unknown or wrong.</summary>
        public long DeclaredEnd;

        /// <summary>Offset of the next cluster, or -1 when this is the last.</summary>
        public long NextOffset;

        /// <summary>Time of the cluster in nanoseconds from the start of the recording.</summary>
        public long TimeNs;

        /// <summary>First byte that the stored checksum covers, or -1 when there is none.</summary>
        public long ChecksumStart;

        public uint Checksum;

        public bool ChecksumVerified;

        /// <summary>The stored checksum does not fit the bytes: a payload or a head in this cluster is damaged.</summary>
        public bool ChecksumMismatch;
    }
}
