namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>One picture of a capture: what it is and where its payload lies. The payload stays on disk until it is asked for.</summary>
    public readonly struct KinectImage
    {
        internal KinectImage(KinectTrack track, long deviceTimeUs, long offset, int sizeBytes, bool isSuspect)
        {
            Track = track;
            DeviceTimeUs = deviceTimeUs;
            Offset = offset;
            SizeBytes = sizeBytes;
            IsSuspect = isSuspect;
        }

        /// <summary>Null when the capture has no such picture.</summary>
        public KinectTrack? Track { get; }

        public bool IsPresent => Track != null;

        /// <summary>Mid-exposure time on the device's clock in microseconds.</summary>
        public long DeviceTimeUs { get; }

        /// <summary>Byte offset of the payload in the file.</summary>
        public long Offset { get; }

        /// <summary>Size of the payload in bytes; not yet checked against the track's format.</summary>
        public int SizeBytes { get; }

        /// <summary>Lies in a cluster whose checksum does not fit (only known while checksums are verified).</summary>
        public bool IsSuspect { get; }
    }
}
