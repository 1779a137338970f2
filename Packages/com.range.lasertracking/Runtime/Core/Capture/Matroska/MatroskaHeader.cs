using System;
using System.Collections.Generic;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// Everything in the segment that is not pictures: time unit, tracks, tags, attachments. Tolerant: what is whole is kept, a list
    /// stops at its first damaged entry, and lists are bounded because an entry may cost more memory than it has bytes in the file.
    /// </summary>
    internal sealed class MatroskaHeader
    {
        private const int MaxTracks = 64;
        private const int MaxTags = 500;
        private const int MaxAttachments = 64;
        private const int MaxCodecPrivate = 4096;

        private readonly EbmlReader _reader;
        private readonly ProblemLog _problems;

        public MatroskaHeader(EbmlReader reader, ProblemLog problems)
        {
            _reader = reader;
            _problems = problems;
        }

        /// <summary>Nanoseconds per time unit. 1000, as Kinect recorders write it, until the file tells otherwise.</summary>
        public long TimecodeScale { get; private set; } = 1000;

        public List<MatroskaTrack> Tracks { get; } = new List<MatroskaTrack>();

        public List<MatroskaTag> Tags { get; } = new List<MatroskaTag>();

        public List<MatroskaAttachment> Attachments { get; } = new List<MatroskaAttachment>();

        /// <summary>Reads a top-level element unless one of its kind has been read before; other kinds are ignored.</summary>
        public void Read(in EbmlElement element, long limit)
        {
            var children = new EbmlChildren(_reader, element, limit);
            switch (element.Id)
            {
                case MatroskaIds.Info:
                    ReadInfo(ref children);
                    break;
                case MatroskaIds.Tracks when Tracks.Count == 0:
                    while (Tracks.Count < MaxTracks && children.MoveNext())
                    {
                        if (children.Current.Id == MatroskaIds.TrackEntry)
                            ReadTrack(children.Current);
                    }

                    break;
                case MatroskaIds.Tags when Tags.Count == 0:
                    while (Tags.Count < MaxTags && children.MoveNext())
                    {
                        if (children.Current.Id == MatroskaIds.Tag)
                            ReadTag(children.Current);
                    }

                    break;
                case MatroskaIds.Attachments when Attachments.Count == 0:
                    while (Attachments.Count < MaxAttachments && children.MoveNext())
                    {
                        if (children.Current.Id == MatroskaIds.AttachedFile)
                            ReadAttachment(children.Current);
                    }

                    break;
                default:
                    return;
            }

            if (children.IsDamaged)
                _problems.Add(element.Offset, "the " + NameOf(element.Id) + " are damaged or cut; what is whole of them is used");
        }

        /// <summary>For messages.</summary>
        public static string NameOf(uint id)
        {
            switch (id)
            {
                case MatroskaIds.Info: return "recording facts";
                case MatroskaIds.Tracks: return "track descriptions";
                case MatroskaIds.Tags: return "tags";
                case MatroskaIds.Attachments: return "attachments";
                case MatroskaIds.Cues: return "cues";
                case MatroskaIds.SeekHead: return "table of contents";
                default: return "elements";
            }
        }

        private void ReadInfo(ref EbmlChildren children)
        {
            // A file with the element but without the value means Matroska's default, one millisecond.
            TimecodeScale = 1000000;
            while (children.MoveNext())
            {
                if (children.Current.Id != MatroskaIds.TimecodeScale || !_reader.TryReadUnsigned(children.Current, out ulong scale))
                    continue;
                if (scale >= 1 && scale <= 1000000000)
                {
                    TimecodeScale = (long)scale;
                }
                else
                {
                    TimecodeScale = 1000;
                    _problems.Add(children.Current.Offset, "the time unit is out of range; 1 microsecond is assumed");
                }
            }
        }

        private void ReadTrack(in EbmlElement entry)
        {
            var track = new MatroskaTrack();
            var children = new EbmlChildren(_reader, entry, entry.End);
            while (children.MoveNext())
            {
                EbmlElement child = children.Current;
                switch (child.Id)
                {
                    case MatroskaIds.TrackNumber: track.Number = ReadNumber(child, 1L << 55); break;
                    case MatroskaIds.TrackUid: _reader.TryReadUnsigned(child, out ulong uid); track.Uid = uid; break;
                    case MatroskaIds.TrackType: track.Type = (int)ReadNumber(child, 255); break;
                    case MatroskaIds.TrackName: track.Name = _reader.ReadString(child); break;
                    case MatroskaIds.CodecId: track.CodecId = _reader.ReadString(child); break;
                    case MatroskaIds.CodecPrivate: track.CodecPrivate = ReadBytes(child); break;
                    case MatroskaIds.DefaultDuration: track.DefaultDurationNs = ReadNumber(child, 1L << 40); break;
                    case MatroskaIds.Video: ReadVideo(child, track); break;
                }
            }

            Tracks.Add(track);
        }

        private void ReadVideo(in EbmlElement video, MatroskaTrack track)
        {
            var children = new EbmlChildren(_reader, video, video.End);
            while (children.MoveNext())
            {
                if (children.Current.Id == MatroskaIds.PixelWidth)
                    track.PixelWidth = (int)ReadNumber(children.Current, int.MaxValue);
                else if (children.Current.Id == MatroskaIds.PixelHeight)
                    track.PixelHeight = (int)ReadNumber(children.Current, int.MaxValue);
            }
        }

        private void ReadTag(in EbmlElement tag)
        {
            ulong trackUid = 0;
            ulong attachmentUid = 0;
            var children = new EbmlChildren(_reader, tag, tag.End);
            while (children.MoveNext())
            {
                EbmlElement child = children.Current;
                if (child.Id == MatroskaIds.Targets)
                {
                    var targets = new EbmlChildren(_reader, child, child.End);
                    while (targets.MoveNext())
                    {
                        if (targets.Current.Id == MatroskaIds.TagTrackUid)
                            _reader.TryReadUnsigned(targets.Current, out trackUid);
                        else if (targets.Current.Id == MatroskaIds.TagAttachmentUid)
                            _reader.TryReadUnsigned(targets.Current, out attachmentUid);
                    }
                }
                else if (child.Id == MatroskaIds.SimpleTag && Tags.Count < MaxTags)
                {
                    ReadSimpleTag(child, trackUid, attachmentUid);
                }
            }
        }

        private void ReadSimpleTag(in EbmlElement simple, ulong trackUid, ulong attachmentUid)
        {
            string name = "";
            string value = "";
            var children = new EbmlChildren(_reader, simple, simple.End);
            while (children.MoveNext())
            {
                if (children.Current.Id == MatroskaIds.TagName)
                    name = _reader.ReadString(children.Current);
                else if (children.Current.Id == MatroskaIds.TagString)
                    value = _reader.ReadString(children.Current);
            }

            if (name.Length > 0)
                Tags.Add(new MatroskaTag(name, value, trackUid, attachmentUid));
        }

        private void ReadAttachment(in EbmlElement file)
        {
            string name = "";
            string mimeType = "";
            ulong uid = 0;
            EbmlElement data = default;
            var children = new EbmlChildren(_reader, file, file.End);
            while (children.MoveNext())
            {
                EbmlElement child = children.Current;
                switch (child.Id)
                {
                    case MatroskaIds.FileName: name = _reader.ReadString(child); break;
                    case MatroskaIds.FileMimeType: mimeType = _reader.ReadString(child); break;
                    case MatroskaIds.FileUid: _reader.TryReadUnsigned(child, out uid); break;
                    case MatroskaIds.FileData: data = child; break;
                }
            }

            if (data.Id != 0)
                Attachments.Add(new MatroskaAttachment(name, mimeType, uid, data.DataOffset, data.Size));
        }

        private long ReadNumber(in EbmlElement element, long max) =>
            _reader.TryReadUnsigned(element, out ulong value) && value <= (ulong)max ? (long)value : 0;

        private byte[] ReadBytes(in EbmlElement element)
        {
            if (element.Size > MaxCodecPrivate)
                return Array.Empty<byte>();
            var bytes = new byte[element.Size];
            return _reader.TryRead(element.DataOffset, bytes) ? bytes : Array.Empty<byte>();
        }
    }
}
