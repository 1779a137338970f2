namespace LaserTracking.Host.Sources
{
    /// <summary>The kinds of input that frames are read from.</summary>
    public enum FrameSourceKind
    {
        AzureKinectRecording,
        Video,
        ImageFolder,
    }
}
