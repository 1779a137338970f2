using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>How the camera was set up for a recording.</summary>
    public sealed class KinectRecordConfiguration
    {
        public KinectImageFormat ColorFormat { get; internal set; }

        /// <summary>Width of the colour pictures in pixels; 0 without colour.</summary>
        public int ColorWidth { get; internal set; }

        public int ColorHeight { get; internal set; }

        public KinectDepthMode DepthMode { get; internal set; }

        /// <summary>Nominal: 5, 15, 25 (Orbbec) or 30. Never compute a time from it.</summary>
        public int FramesPerSecond { get; internal set; }

        /// <summary>Exact nominal time between two captures in nanoseconds; half of it is the window of one capture.</summary>
        public long FramePeriodNs { get; internal set; }

        public bool HasColor { get; internal set; }

        public bool HasDepth { get; internal set; }

        public bool HasInfrared { get; internal set; }

        public bool HasImu { get; internal set; }

        /// <summary>How much later than colour the depth pictures were taken, in microseconds; negative = earlier.</summary>
        public long DepthDelayOffColorUs { get; internal set; }

        public KinectWiredSyncMode WiredSyncMode { get; internal set; }

        /// <summary>Delay behind the master camera in microseconds.</summary>
        public long SubordinateDelayOffMasterUs { get; internal set; }

        /// <summary>Device time of the recording's first block in microseconds; 64 bits, since some cameras count from 1970.</summary>
        public long StartOffsetUs { get; internal set; }

        /// <summary>Where the stored colour pictures lie in the camera's, when only a part was recorded; null: they are whole.</summary>
        public PixelRegion? ColorRegion { get; internal set; }

        /// <summary>"720P", "1080P", … by height; "OFF" without colour.</summary>
        public string ColorResolutionName => HasColor ? ColorHeight + "P" : "OFF";
    }
}
