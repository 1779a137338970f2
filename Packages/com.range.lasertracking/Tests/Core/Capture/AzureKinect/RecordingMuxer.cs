using System;
using System.Collections.Generic;
using System.Text;
using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Writes tiny recordings into memory for tests: 16×8 pixel pictures, 1 µs time unit, one cluster per call.</summary>
    internal sealed class RecordingMuxer
    {
        public const int Width = 16;
        public const int Height = 8;
        public const int Color = 1;
        public const int Depth = 2;
        public const int Infrared = 3;
        public const int Imu = 4;
        public const int Custom = 5;

        private readonly List<byte[]> _tracks = new List<byte[]>();
        private readonly List<byte[]> _tags = new List<byte[]>();
        private readonly List<byte[]> _attachments = new List<byte[]>();
        private readonly List<byte[]> _clusters = new List<byte[]>();
        private readonly List<ulong> _clusterTimes = new List<ulong>();

        public EbmlBuilder.SizeField SegmentSize { get; set; } = EbmlBuilder.SizeField.Right;

        public EbmlBuilder.SizeField ClusterSize { get; set; } = EbmlBuilder.SizeField.Right;

        public bool WritesChecksums { get; set; } = true;

        public bool WritesInfo { get; set; } = true;

        public bool WritesCues { get; set; } = true;

        /// <summary>Bytes put between the clusters.</summary>
        public byte[] BetweenClusters { get; set; } = Array.Empty<byte>();

        /// <summary>Colour (NV12), depth, infrared, motion and one custom track at 30 frames a second.</summary>
        public static RecordingMuxer WithAllTracks()
        {
            var muxer = new RecordingMuxer();
            muxer.AddVideo(Color, "COLOR", "NV12");
            muxer.AddVideo(Depth, "DEPTH", "b16g");
            muxer.AddVideo(Infrared, "IR", "b16g");
            muxer.AddData(Imu, "IMU", "S_K4A/IMU");
            muxer.AddData(Custom, "EVENTS", "S_TEXT/UTF8");
            return muxer;
        }

        public void AddVideo(int number, string name, string fourCc, uint periodNs = 33333333, int width = Width, int height = Height)
        {
            var header = new byte[40];
            header[0] = 40;
            BitConverter.GetBytes(width).CopyTo(header, 4);
            BitConverter.GetBytes(height).CopyTo(header, 8);
            Encoding.ASCII.GetBytes(fourCc).CopyTo(header, 16);
            _tracks.Add(EbmlBuilder.Element(MatroskaIds.TrackEntry,
                EbmlBuilder.Unsigned(MatroskaIds.TrackNumber, (ulong)number),
                EbmlBuilder.Unsigned(MatroskaIds.TrackUid, (ulong)number + 1000),
                EbmlBuilder.Unsigned(MatroskaIds.TrackType, 1),
                EbmlBuilder.Text(MatroskaIds.CodecId, "V_MS/VFW/FOURCC"),
                EbmlBuilder.Element(MatroskaIds.CodecPrivate, header),
                EbmlBuilder.Text(MatroskaIds.TrackName, name),
                EbmlBuilder.Unsigned(MatroskaIds.DefaultDuration, periodNs),
                EbmlBuilder.Element(MatroskaIds.Video,
                    EbmlBuilder.Unsigned(MatroskaIds.PixelWidth, (ulong)width), EbmlBuilder.Unsigned(MatroskaIds.PixelHeight, (ulong)height))));
        }

        public void AddData(int number, string name, string codec)
        {
            _tracks.Add(EbmlBuilder.Element(MatroskaIds.TrackEntry,
                EbmlBuilder.Unsigned(MatroskaIds.TrackNumber, (ulong)number),
                EbmlBuilder.Unsigned(MatroskaIds.TrackUid, (ulong)number + 1000),
                EbmlBuilder.Unsigned(MatroskaIds.TrackType, 17),
                EbmlBuilder.Text(MatroskaIds.CodecId, codec),
                EbmlBuilder.Text(MatroskaIds.TrackName, name)));
        }

        public void AddTag(string name, string value, ulong attachmentUid = 0)
        {
            _tags.Add(EbmlBuilder.Element(MatroskaIds.Tag,
                EbmlBuilder.Element(MatroskaIds.Targets, EbmlBuilder.Unsigned(MatroskaIds.TagAttachmentUid, attachmentUid)),
                EbmlBuilder.Element(MatroskaIds.SimpleTag,
                    EbmlBuilder.Text(MatroskaIds.TagName, name), EbmlBuilder.Text(MatroskaIds.TagString, value))));
        }

        public void AddAttachment(string name, ulong uid, byte[] content)
        {
            _attachments.Add(EbmlBuilder.Element(MatroskaIds.AttachedFile,
                EbmlBuilder.Text(MatroskaIds.FileName, name),
                EbmlBuilder.Unsigned(MatroskaIds.FileUid, uid),
                EbmlBuilder.Element(MatroskaIds.FileData, content)));
        }

        public void AddCluster(ulong timecode, params byte[][] blocks)
        {
            byte[] content = EbmlBuilder.Join(EbmlBuilder.Unsigned(MatroskaIds.Timecode, timecode), EbmlBuilder.Join(blocks));
            if (WritesChecksums)
                content = EbmlBuilder.Join(EbmlBuilder.Element(MatroskaIds.Crc32, BitConverter.GetBytes(Crc32.Append(0, content))), content);
            _clusters.Add(EbmlBuilder.Element(MatroskaIds.Cluster, ClusterSize, content));
            _clusterTimes.Add(timecode);
        }

        /// <summary>One picture's block with a payload of the right size, filled with a value.</summary>
        public static byte[] Picture(int track, short relativeTime, byte fill = 0)
        {
            int size = track == Color ? Width * Height * 3 / 2 : Width * Height * 2;
            var payload = new byte[size];
            Array.Fill(payload, fill);
            return SimpleBlock(track, relativeTime, 0x80, payload);
        }

        public static byte[] SimpleBlock(int track, short relativeTime, byte flags, byte[] payload) =>
            EbmlBuilder.Element(MatroskaIds.SimpleBlock, BlockHead(track, relativeTime, flags), payload);

        public static byte[] BlockGroup(int track, short relativeTime, byte flags, ulong duration, byte[] payload) =>
            EbmlBuilder.Element(MatroskaIds.BlockGroup,
                EbmlBuilder.Element(MatroskaIds.Block, BlockHead(track, relativeTime, flags), payload),
                EbmlBuilder.Unsigned(MatroskaIds.BlockDuration, duration));

        public static byte[] ImuSample(ulong timeUs)
        {
            var sample = new byte[40];
            BitConverter.GetBytes(timeUs * 1000).CopyTo(sample, 0);
            BitConverter.GetBytes(9.8f).CopyTo(sample, 8);
            BitConverter.GetBytes(timeUs * 1000 + 500).CopyTo(sample, 20);
            return sample;
        }

        public byte[] ToArray()
        {
            byte[] head = EbmlBuilder.Element(MatroskaIds.EbmlHead,
                EbmlBuilder.Text(MatroskaIds.DocType, "matroska"), EbmlBuilder.Unsigned(MatroskaIds.DocTypeReadVersion, 2));
            byte[] info = WritesInfo ? EbmlBuilder.Element(MatroskaIds.Info, EbmlBuilder.Unsigned(MatroskaIds.TimecodeScale, 1000)) : Array.Empty<byte>();
            byte[] tracks = EbmlBuilder.Element(MatroskaIds.Tracks, _tracks.ToArray());
            byte[] tags = EbmlBuilder.Element(MatroskaIds.Tags, _tags.ToArray());
            byte[] attachments = EbmlBuilder.Element(MatroskaIds.Attachments, _attachments.ToArray());
            byte[] front = EbmlBuilder.Join(info, tracks, attachments, tags, EbmlBuilder.Element(MatroskaIds.Void, new byte[7]));
            byte[] seekHead = SeekHead(0);
            var positions = new List<long>();
            long position = seekHead.Length + front.Length;
            var body = new List<byte[]> { front };
            foreach (byte[] cluster in _clusters)
            {
                positions.Add(position);
                body.Add(cluster);
                body.Add(BetweenClusters);
                position += cluster.Length + BetweenClusters.Length;
            }

            if (WritesCues)
            {
                body.Insert(0, SeekHead(position));
                var points = new List<byte[]>();
                for (int i = 0; i < positions.Count; i++)
                {
                    points.Add(EbmlBuilder.Element(MatroskaIds.CuePoint,
                        EbmlBuilder.Unsigned(MatroskaIds.CueTime, _clusterTimes[i]),
                        EbmlBuilder.Element(MatroskaIds.CueTrackPositions, EbmlBuilder.Unsigned(MatroskaIds.CueClusterPosition, (ulong)positions[i]))));
                }

                body.Add(EbmlBuilder.Element(MatroskaIds.Cues, points.ToArray()));
            }

            return EbmlBuilder.Join(head, EbmlBuilder.Element(MatroskaIds.Segment, SegmentSize, body.ToArray()));
        }

        private static byte[] BlockHead(int track, short relativeTime, byte flags) =>
            new[] { (byte)(0x80 | track), (byte)(relativeTime >> 8), (byte)relativeTime, flags };

        /// <summary>Always of one length, so that what follows does not move.</summary>
        private static byte[] SeekHead(long cues)
        {
            var position = new byte[8];
            for (int i = 0; i < 8; i++)
                position[i] = (byte)(cues >> (56 - 8 * i));
            return EbmlBuilder.Element(MatroskaIds.SeekHead, EbmlBuilder.Element(MatroskaIds.Seek,
                EbmlBuilder.Element(MatroskaIds.SeekId, new byte[] { 0x1C, 0x53, 0xBB, 0x6B }),
                EbmlBuilder.Element(MatroskaIds.SeekPosition, position)));
        }
    }
}
