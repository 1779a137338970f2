namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Operating modes of the depth camera (NFOV, WFOV = narrow, wide field of view).</summary>
    public enum KinectDepthMode : byte
    {
        Off = 0,

        /// <summary>320×288.</summary>
        Nfov2x2Binned,

        /// <summary>640×576.</summary>
        NfovUnbinned,

        /// <summary>512×512.</summary>
        Wfov2x2Binned,

        /// <summary>1024×1024.</summary>
        WfovUnbinned,

        /// <summary>1024×1024, infrared only.</summary>
        PassiveIr,
    }
}
