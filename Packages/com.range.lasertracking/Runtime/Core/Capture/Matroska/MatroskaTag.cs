namespace LaserTracking.Capture.Matroska
{
    /// <summary>One named text value, for the whole file or for one track or attachment.</summary>
    public sealed class MatroskaTag
    {
        public MatroskaTag(string name, string value, ulong trackUid, ulong attachmentUid)
        {
            Name = name;
            Value = value;
            TrackUid = trackUid;
            AttachmentUid = attachmentUid;
        }

        public string Name { get; }

        public string Value { get; }

        /// <summary>The track that it describes; 0 = none.</summary>
        public ulong TrackUid { get; }

        /// <summary>The attachment that it describes; 0 = none.</summary>
        public ulong AttachmentUid { get; }
    }
}
