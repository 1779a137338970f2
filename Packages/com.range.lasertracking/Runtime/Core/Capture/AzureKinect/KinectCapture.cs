namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Pictures that belong together: any non-empty subset of colour, depth and infrared. Reused from read to read.</summary>
    public sealed class KinectCapture
    {
        /// <summary>0-based from the start of the recording; -1 after a seek by time until the start is met again.</summary>
        public int Index { get; internal set; } = -1;

        public KinectImage Color { get; internal set; }

        public KinectImage Depth { get; internal set; }

        public KinectImage Infrared { get; internal set; }

        /// <summary>Device time in microseconds of the first picture that is present, in the order colour, depth, infrared.</summary>
        public long DeviceTimeUs =>
            Color.IsPresent ? Color.DeviceTimeUs : Depth.IsPresent ? Depth.DeviceTimeUs : Infrared.DeviceTimeUs;

        internal void Clear()
        {
            Index = -1;
            Color = Depth = Infrared = default;
        }
    }
}
