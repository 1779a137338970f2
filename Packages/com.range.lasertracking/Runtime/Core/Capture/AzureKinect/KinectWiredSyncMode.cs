namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>The camera's part in a chain of cameras joined by sync cables.</summary>
    public enum KinectWiredSyncMode : byte
    {
        Standalone = 0,
        Master,
        Subordinate,
    }
}
