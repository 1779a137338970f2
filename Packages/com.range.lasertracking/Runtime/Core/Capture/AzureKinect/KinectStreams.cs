using System;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Which pictures of a recording are wanted. The payloads of the others are never read.</summary>
    [Flags]
    public enum KinectStreams
    {
        None = 0,
        Color = 1,
        Depth = 2,
        Infrared = 4,
        All = Color | Depth | Infrared,
    }
}
