namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>How the pictures of a track are stored; the names are the recording format's own.</summary>
    public enum KinectImageFormat : byte
    {
        /// <summary>Unknown or damaged description: pictures of this track cannot be used.</summary>
        Unknown = 0,
        Mjpg,
        Nv12,
        Yuy2,
        Bgra32,

        /// <summary>Distance in mm, 16 bit, handed out little-endian.</summary>
        Depth16,

        /// <summary>Infrared brightness, 16 bit, handed out little-endian.</summary>
        Ir16,

        /// <summary>One byte of brightness; not a format of the Kinect, written by this package for grey webcams.</summary>
        Gray8,
    }
}
