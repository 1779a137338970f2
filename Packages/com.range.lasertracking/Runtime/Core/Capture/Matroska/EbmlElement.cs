namespace LaserTracking.Capture.Matroska
{
    /// <summary>The head of one element: where it lies and how long it says to be. All offsets are bytes from the start of the file.</summary>
    public readonly struct EbmlElement
    {
        public EbmlElement(uint id, long offset, int headLength, long size)
        {
            Id = id;
            Offset = offset;
            DataOffset = offset + headLength;
            Size = size;
        }

        public uint Id { get; }

        public long Offset { get; }

        public long DataOffset { get; }

        /// <summary>Declared size of the data, unchecked against the file; <see cref="EbmlVarint.UnknownSize"/> when open-ended.</summary>
        public long Size { get; }

        public bool SizeIsKnown => Size != EbmlVarint.UnknownSize;

        /// <summary>First byte behind the element, or <see cref="long.MaxValue"/> when its size is unknown.</summary>
        public long End => SizeIsKnown ? DataOffset + Size : long.MaxValue;
    }
}
