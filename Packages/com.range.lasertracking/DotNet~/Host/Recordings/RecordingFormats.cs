using LaserTracking.Capture.AzureKinect;

namespace LaserTracking.Host.Recordings
{
    /// <summary>How formats are written in results, and the ending of a payload's file.</summary>
    internal static class RecordingFormats
    {
        public static string NameOf(KinectTrack track) => track.Format switch
        {
            KinectImageFormat.Mjpg => "MJPG",
            KinectImageFormat.Nv12 => "NV12",
            KinectImageFormat.Yuy2 => "YUY2",
            KinectImageFormat.Bgra32 => "BGRA32",
            KinectImageFormat.Depth16 => "DEPTH16",
            KinectImageFormat.Ir16 => "IR16",
            KinectImageFormat.Gray8 => "GRAY8",
            _ => track.CodecId,
        };

        public static string ExtensionOf(KinectTrack track) => track.Format switch
        {
            KinectImageFormat.Mjpg => ".jpg",
            KinectImageFormat.Unknown => ".bin",
            _ => "." + NameOf(track).ToLowerInvariant(),
        };
    }
}
