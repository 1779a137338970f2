namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// Walks the children of a master element. Stops at the first head that makes no sense or child that does not fit, and says so:
    /// what came before it is good.
    /// </summary>
    internal struct EbmlChildren
    {
        private readonly EbmlReader _reader;
        private readonly long _end;
        private long _position;

        /// <param name="reader">The file.</param>
        /// <param name="parent">A master element; an open-ended one reaches to <paramref name="limit"/>.</param>
        /// <param name="limit">No child may cross this offset.</param>
        public EbmlChildren(EbmlReader reader, in EbmlElement parent, long limit)
        {
            _reader = reader;
            _position = parent.DataOffset;
            _end = parent.End < limit ? parent.End : limit;
            IsDamaged = parent.SizeIsKnown && parent.End > limit;
            Current = default;
        }

        public EbmlElement Current { get; private set; }

        /// <summary>The parent is cut, or its children ended at something that is no element.</summary>
        public bool IsDamaged { get; private set; }

        public bool MoveNext()
        {
            if (_position >= _end)
                return false;
            if (!_reader.TryReadElement(_position, _end, out EbmlElement element) || element.End > _end)
            {
                IsDamaged = true;
                return false;
            }

            Current = element;
            _position = element.End;
            return true;
        }
    }
}
