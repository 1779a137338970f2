namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>What an offset in a recording is measured from.</summary>
    public enum KinectSeekOrigin : byte
    {
        /// <summary>The first block of the recording, of whatever track.</summary>
        Begin = 0,

        /// <summary>The last time in the recording; 0 is behind it, negative offsets lie before it.</summary>
        End,

        /// <summary>The device's clock, as in picture timestamps.</summary>
        DeviceTime,
    }
}
