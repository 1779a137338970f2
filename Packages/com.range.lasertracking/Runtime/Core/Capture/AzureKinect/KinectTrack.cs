using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>One track of a recording.</summary>
    public sealed class KinectTrack
    {
        internal KinectTrack(MatroskaTrack source, string name)
        {
            Source = source;
            Name = name;
        }

        internal MatroskaTrack Source { get; }

        /// <summary>COLOR, DEPTH, IR, IMU, or a custom track's own name.</summary>
        public string Name { get; }

        /// <summary>One of the four that every camera can have; any other is custom data.</summary>
        public bool IsBuiltin { get; internal set; }

        public string CodecId => Source.CodecId;

        /// <summary>The codec's description; a BITMAPINFOHEADER for pictures. Do not change it.</summary>
        public byte[] CodecPrivate => Source.CodecPrivate;

        public bool IsVideo => Source.Type == 1;

        /// <summary>Only for the builtin picture tracks.</summary>
        public KinectImageFormat Format { get; internal set; }

        /// <summary>The 16-bit samples are stored most significant byte first.</summary>
        internal bool IsBigEndian { get; set; }

        public int Width { get; internal set; }

        public int Height { get; internal set; }

        /// <summary>Nominal, rounded; 0 for tracks without a frame rate.</summary>
        public int FramesPerSecond =>
            Source.DefaultDurationNs > 0 ? (int)(1000000000 / Source.DefaultDurationNs) : 0;

        /// <summary>Bytes from row to row as delivered; 0 for MJPG.</summary>
        public int Stride
        {
            get
            {
                switch (Format)
                {
                    case KinectImageFormat.Gray8:
                    case KinectImageFormat.Nv12: return Width;
                    case KinectImageFormat.Yuy2:
                    case KinectImageFormat.Depth16:
                    case KinectImageFormat.Ir16: return Width * 2;
                    case KinectImageFormat.Bgra32: return Width * 4;
                    default: return 0;
                }
            }
        }
    }
}
