namespace LaserTracking.OpenCv
{
    /// <summary>Through which of the operating system's doors OpenCV reaches a webcam.</summary>
    public enum WebcamBackend
    {
        /// <summary>The one of this operating system that lets exposure be locked: DirectShow, Video4Linux or AVFoundation.</summary>
        Automatic = 0,
        VideoForLinux = 200,
        DirectShow = 700,
        AvFoundation = 1200,
        MediaFoundation = 1400,
    }
}
