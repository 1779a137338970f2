using System.Collections.Generic;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>What stands in a Matroska file before its first cluster, in the terms that the reader gives it in, and how it is written.</summary>
    internal sealed class MatroskaHead
    {
        private const string MuxingApp = "com.range.lasertracking";

        /// <summary>Number, uid, type, name, codec and, for pictures, size and period of each.</summary>
        public List<MatroskaTrack> Tracks { get; } = new List<MatroskaTrack>();

        public List<MatroskaTag> Tags { get; } = new List<MatroskaTag>();

        /// <summary>Files with their content; offset and size are not used.</summary>
        public List<(MatroskaAttachment File, byte[] Content)> Attachments { get; } = new List<(MatroskaAttachment, byte[])>();

        /// <summary>The EBML head and the open-ended beginning of the segment: the last 8 bytes are its size.</summary>
        public void WriteFileHead(EbmlWriter to)
        {
            int head = to.Begin(MatroskaIds.EbmlHead);
            to.Unsigned(MatroskaIds.EbmlVersion, 1);
            to.Unsigned(MatroskaIds.EbmlReadVersion, 1);
            to.Unsigned(MatroskaIds.EbmlMaxIdLength, 4);
            to.Unsigned(MatroskaIds.EbmlMaxSizeLength, 8);
            to.Text(MatroskaIds.DocType, "matroska");
            to.Unsigned(MatroskaIds.DocTypeVersion, 2);
            to.Unsigned(MatroskaIds.DocTypeReadVersion, 2);
            to.End(head);
            to.Head(MatroskaIds.Segment, EbmlVarint.UnknownSize);
        }

        /// <param name="to">Destination.</param>
        /// <param name="durationUs">Null while it is not known.</param>
        public void WriteInfo(EbmlWriter to, double? durationUs)
        {
            int info = to.Begin(MatroskaIds.Info);
            to.Unsigned(MatroskaIds.TimecodeScale, 1000);
            to.Text(MatroskaIds.MuxingApp, MuxingApp);
            to.Text(MatroskaIds.WritingApp, MuxingApp);
            if (durationUs is double known)
                to.Float(MatroskaIds.Duration, known);
            to.End(info);
        }

        public void WriteTracks(EbmlWriter to)
        {
            int tracks = to.Begin(MatroskaIds.Tracks);
            foreach (MatroskaTrack track in Tracks)
            {
                int entry = to.Begin(MatroskaIds.TrackEntry);
                to.Unsigned(MatroskaIds.TrackNumber, (ulong)track.Number);
                to.Unsigned(MatroskaIds.TrackUid, track.Uid);
                to.Unsigned(MatroskaIds.TrackType, (ulong)track.Type);
                to.Text(MatroskaIds.TrackName, track.Name);
                to.Text(MatroskaIds.CodecId, track.CodecId);
                if (track.CodecPrivate.Length > 0)
                    to.Binary(MatroskaIds.CodecPrivate, track.CodecPrivate);
                if (track.DefaultDurationNs > 0)
                    to.Unsigned(MatroskaIds.DefaultDuration, (ulong)track.DefaultDurationNs);
                if (track.PixelWidth > 0 && track.PixelHeight > 0)
                {
                    int video = to.Begin(MatroskaIds.Video);
                    to.Unsigned(MatroskaIds.PixelWidth, (ulong)track.PixelWidth);
                    to.Unsigned(MatroskaIds.PixelHeight, (ulong)track.PixelHeight);
                    to.End(video);
                }

                to.End(entry);
            }

            to.End(tracks);
        }

        public void WriteAttachments(EbmlWriter to)
        {
            int attachments = to.Begin(MatroskaIds.Attachments);
            foreach ((MatroskaAttachment file, byte[] content) in Attachments)
            {
                int entry = to.Begin(MatroskaIds.AttachedFile);
                to.Text(MatroskaIds.FileName, file.Name);
                to.Text(MatroskaIds.FileMimeType, file.MimeType);
                to.Binary(MatroskaIds.FileData, content);
                to.Unsigned(MatroskaIds.FileUid, file.Uid);
                to.End(entry);
            }

            to.End(attachments);
        }

        public void WriteTags(EbmlWriter to)
        {
            int tags = to.Begin(MatroskaIds.Tags);
            foreach (MatroskaTag tag in Tags)
            {
                int entry = to.Begin(MatroskaIds.Tag);
                int targets = to.Begin(MatroskaIds.Targets);
                if (tag.AttachmentUid != 0)
                    to.Unsigned(MatroskaIds.TagAttachmentUid, tag.AttachmentUid);
                else
                    to.Unsigned(MatroskaIds.TagTrackUid, tag.TrackUid);
                to.End(targets);
                int simple = to.Begin(MatroskaIds.SimpleTag);
                to.Text(MatroskaIds.TagName, tag.Name);
                to.Text(MatroskaIds.TagString, tag.Value);
                to.End(simple);
                to.End(entry);
            }

            to.End(tags);
        }
    }
}
