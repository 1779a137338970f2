using LaserTracking.Imaging;

namespace LaserTracking.Capture
{
    /// <summary>What is known of a stream before its first frame is read.</summary>
    public sealed class FrameSourceInfo
    {
        public FrameSourceInfo(string name, int width, int height, double nominalFramesPerSecond, long? durationUs)
        {
            Name = name;
            Width = width;
            Height = height;
            NominalFramesPerSecond = nominalFramesPerSecond;
            DurationUs = durationUs;
        }

        /// <summary>For people: a file name, a camera's serial number, "simulation seed 7".</summary>
        public string Name { get; }

        /// <summary>Size of the colour picture, or of depth where there is no colour; 0 when unknown.</summary>
        public int Width { get; }

        public int Height { get; }

        /// <summary>As declared; 0 when unknown. Never compute a time from it: frames carry their own.</summary>
        public double NominalFramesPerSecond { get; }

        /// <summary>Length in microseconds where the container tells; for progress only.</summary>
        public long? DurationUs { get; }
    }
}
