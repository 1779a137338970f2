namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>One frame of a custom track.</summary>
    public readonly struct KinectDataBlock
    {
        internal KinectDataBlock(long deviceTimeUs, long offset, int sizeBytes)
        {
            DeviceTimeUs = deviceTimeUs;
            Offset = offset;
            SizeBytes = sizeBytes;
        }

        /// <summary>Device time in microseconds; interpolated over the block's duration where several frames share one block.</summary>
        public long DeviceTimeUs { get; }

        /// <summary>Byte offset of the payload in the file.</summary>
        public long Offset { get; }

        public int SizeBytes { get; }
    }
}
