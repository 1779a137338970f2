namespace LaserTracking.Capture.Matroska
{
    /// <summary>Element ids of Matroska (RFC 9559) that a recording needs.</summary>
    internal static class MatroskaIds
    {
        public const uint EbmlHead = 0x1A45DFA3;
        public const uint EbmlVersion = 0x4286;
        public const uint EbmlReadVersion = 0x42F7;
        public const uint EbmlMaxIdLength = 0x42F2;
        public const uint EbmlMaxSizeLength = 0x42F3;
        public const uint DocType = 0x4282;
        public const uint DocTypeVersion = 0x4287;
        public const uint DocTypeReadVersion = 0x4285;
        public const uint Void = 0xEC;
        public const uint Crc32 = 0xBF;

        public const uint Segment = 0x18538067;
        public const uint SeekHead = 0x114D9B74;
        public const uint Seek = 0x4DBB;
        public const uint SeekId = 0x53AB;
        public const uint SeekPosition = 0x53AC;
        public const uint Info = 0x1549A966;
        public const uint TimecodeScale = 0x2AD7B1;
        public const uint Duration = 0x4489;
        public const uint MuxingApp = 0x4D80;
        public const uint WritingApp = 0x5741;

        public const uint Tracks = 0x1654AE6B;
        public const uint TrackEntry = 0xAE;
        public const uint TrackNumber = 0xD7;
        public const uint TrackUid = 0x73C5;
        public const uint TrackType = 0x83;
        public const uint CodecId = 0x86;
        public const uint CodecPrivate = 0x63A2;
        public const uint TrackName = 0x536E;
        public const uint DefaultDuration = 0x23E383;
        public const uint Video = 0xE0;
        public const uint PixelWidth = 0xB0;
        public const uint PixelHeight = 0xBA;

        public const uint Attachments = 0x1941A469;
        public const uint AttachedFile = 0x61A7;
        public const uint FileName = 0x466E;
        public const uint FileMimeType = 0x4660;
        public const uint FileData = 0x465C;
        public const uint FileUid = 0x46AE;

        public const uint Tags = 0x1254C367;
        public const uint Tag = 0x7373;
        public const uint Targets = 0x63C0;
        public const uint TagTrackUid = 0x63C5;
        public const uint TagAttachmentUid = 0x63C6;
        public const uint SimpleTag = 0x67C8;
        public const uint TagName = 0x45A3;
        public const uint TagString = 0x4487;

        public const uint Cluster = 0x1F43B675;
        public const uint Timecode = 0xE7;
        public const uint SilentTracks = 0x5854;
        public const uint Position = 0xA7;
        public const uint PreviousSize = 0xAB;
        public const uint SimpleBlock = 0xA3;
        public const uint BlockGroup = 0xA0;
        public const uint Block = 0xA1;
        public const uint BlockDuration = 0x9B;

        public const uint Cues = 0x1C53BB6B;
        public const uint CuePoint = 0xBB;
        public const uint CueTime = 0xB3;
        public const uint CueTrackPositions = 0xB7;
        public const uint CueTrack = 0xF7;
        public const uint CueClusterPosition = 0xF1;
        public const uint Chapters = 0x1043A770;

        /// <summary>Elements that stand directly in the segment: meeting one inside a cluster means that the cluster is over.</summary>
        public static bool IsTopLevel(uint id)
        {
            switch (id)
            {
                case Cluster:
                case SeekHead:
                case Info:
                case Tracks:
                case Attachments:
                case Tags:
                case Cues:
                case Chapters:
                    return true;
                default:
                    return false;
            }
        }

        /// <summary>Elements that may be a cluster's first child: what tells a real cluster from four chance bytes.</summary>
        public static bool MayBeginCluster(uint id)
        {
            switch (id)
            {
                case Timecode:
                case Crc32:
                case Void:
                case SilentTracks:
                case Position:
                case PreviousSize:
                case SimpleBlock:
                case BlockGroup:
                    return true;
                default:
                    return false;
            }
        }
    }
}
