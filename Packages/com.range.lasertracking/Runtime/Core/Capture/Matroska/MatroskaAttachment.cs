namespace LaserTracking.Capture.Matroska
{
    /// <summary>A file inside the file; its bytes stay on disk until they are asked for.</summary>
    public sealed class MatroskaAttachment
    {
        public MatroskaAttachment(string name, string mimeType, ulong uid, long dataOffset, long size)
        {
            Name = name;
            MimeType = mimeType;
            Uid = uid;
            DataOffset = dataOffset;
            Size = size;
        }

        public string Name { get; }

        public string MimeType { get; }

        public ulong Uid { get; }

        /// <summary>Byte offset in the file.</summary>
        public long DataOffset { get; }

        /// <summary>Size in bytes; it has been checked to lie inside the file.</summary>
        public long Size { get; }
    }
}
