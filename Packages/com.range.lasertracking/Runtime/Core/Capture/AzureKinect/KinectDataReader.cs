using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Goes through the frames of one track of any kind, from its first. Independent of the capture being read.</summary>
    public sealed class KinectDataReader
    {
        private readonly EbmlReader _reader;
        private readonly BlockCursor _cursor;
        private readonly ProblemLog _problems;
        private readonly long _startOffsetUs;
        private readonly BlockLacing _lacing = new BlockLacing();

        private MatroskaBlock _block;
        private int _frame;

        internal KinectDataReader(EbmlReader reader, BlockCursor cursor, ProblemLog problems, long startOffsetUs)
        {
            _reader = reader;
            _cursor = cursor;
            _problems = problems;
            _startOffsetUs = startOffsetUs;
        }

        /// <summary>The next frame; false at the end. Allocates nothing.</summary>
        public bool TryReadNext(out KinectDataBlock data)
        {
            while (_frame >= _lacing.Count)
            {
                if (!_cursor.TryPeekNext(out _block))
                {
                    data = default;
                    return false;
                }

                _cursor.MoveNext();
                _frame = 0;
                if (!_lacing.TrySplit(_reader, _block) && _problems.Accepts(_block.ElementOffset))
                    _problems.Add(_block.ElementOffset, "the lacing of this block does not fit its size; the block is lost");
            }

            long timeNs = _block.TimeNs;
            if (_frame > 0 && _block.DurationNs > 0)
                timeNs += (long)((decimal)_frame * (_block.DurationNs - 1) / (_lacing.Count - 1));
            data = new KinectDataBlock(timeNs / 1000 + _startOffsetUs, _lacing.OffsetOf(_frame), _lacing.SizeOf(_frame));
            _frame++;
            return true;
        }
    }
}
