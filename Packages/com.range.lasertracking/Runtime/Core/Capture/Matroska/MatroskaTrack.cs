using System;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>One track entry as the file declares it.</summary>
    public sealed class MatroskaTrack
    {
        /// <summary>Number that blocks carry; 0 when the entry has none.</summary>
        public long Number { get; internal set; }

        public ulong Uid { get; internal set; }

        /// <summary>1 = video, 17 = subtitle.</summary>
        public int Type { get; internal set; }

        public string Name { get; internal set; } = "";

        public string CodecId { get; internal set; } = "";

        /// <summary>At most 4 KiB; empty when absent.</summary>
        public byte[] CodecPrivate { get; internal set; } = Array.Empty<byte>();

        /// <summary>Nominal time between two frames in nanoseconds; 0 when absent.</summary>
        public long DefaultDurationNs { get; internal set; }

        /// <summary>Width in pixels; 0 when absent.</summary>
        public int PixelWidth { get; internal set; }

        /// <summary>Height in pixels; 0 when absent.</summary>
        public int PixelHeight { get; internal set; }
    }
}
