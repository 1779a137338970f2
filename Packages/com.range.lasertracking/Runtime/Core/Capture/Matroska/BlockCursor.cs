using System;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// A place between two blocks of one track. Looks at the block before and the block behind it and steps over them; file order,
    /// as recorders write it, is the order. Reads block heads only. The last 64 blocks passed are remembered, so that going back
    /// does not walk a long cluster again for each block.
    /// </summary>
    internal sealed class BlockCursor
    {
        private const int MaxRemembered = 64;

        private readonly EbmlReader _reader;
        private readonly ClusterMap _clusters;
        private readonly BlockParser _parser;

        private MatroskaBlock[]? _behind;
        private int _behindTop;
        private int _behindCount;
        private bool _isAtStart;

        private MatroskaCluster _cluster;
        private long _gap;
        private bool _hasCluster;

        private MatroskaBlock _next;
        private MatroskaCluster _nextCluster;
        private bool _nextIsKnown;
        private bool _hasNext;

        // The longest stretch without a block of this track that was met going each way: a track with few or no blocks would
        // otherwise be searched through the whole file after every seek.
        private long _emptyAheadFrom = long.MaxValue;
        private long _emptyAheadTo;
        private MatroskaBlock _afterEmpty;
        private MatroskaCluster _afterEmptyCluster;
        private long _emptyBehindFrom = long.MaxValue;
        private long _emptyBehindTo;
        private MatroskaBlock _beforeEmpty;

        public BlockCursor(EbmlReader reader, ClusterMap clusters, ProblemLog problems, long track, long timecodeScale)
        {
            _reader = reader;
            _clusters = clusters;
            _parser = new BlockParser(reader, problems, track, timecodeScale);
            SeekToStart();
        }

        public void SeekToStart()
        {
            _hasCluster = _clusters.TryFirst(out MatroskaCluster first);
            Place(first);
        }

        /// <summary>Goes before the first block of a cluster.</summary>
        public void PlaceAt(in MatroskaCluster cluster)
        {
            _hasCluster = true;
            Place(cluster);
        }

        /// <summary>Goes before the first block whose time is not before the given one, searching from a cluster safely before it.</summary>
        public void Seek(long timeNs)
        {
            _hasCluster = _clusters.TryFind(timeNs, out MatroskaCluster cluster);
            Place(cluster);
            while (TryPeekNext(out MatroskaBlock block) && block.TimeNs < timeNs)
                MoveNext();
        }

        public bool TryPeekNext(out MatroskaBlock block)
        {
            if (!_nextIsKnown)
            {
                _hasNext = FindNext();
                _nextIsKnown = true;
            }

            block = _next;
            return _hasNext;
        }

        public bool TryPeekPrevious(out MatroskaBlock block)
        {
            if (_behindCount == 0 && !_isAtStart)
            {
                FindPrevious();
                _isAtStart = _behindCount == 0;
            }

            block = _behind != null && _behindCount > 0 ? _behind[_behindTop] : default;
            return _behindCount > 0;
        }

        /// <summary>Steps over the next block, if there is one.</summary>
        public void MoveNext()
        {
            if (!TryPeekNext(out MatroskaBlock block))
                return;
            Remember(block);
            _cluster = _nextCluster;
            _gap = block.ElementEnd;
            _nextIsKnown = false;
        }

        /// <summary>Steps back over the previous block, if there is one.</summary>
        public void MovePrevious()
        {
            if (!TryPeekPrevious(out MatroskaBlock block))
                return;
            while (_cluster.Offset != block.ClusterOffset && _clusters.TryPrevious(_cluster, out MatroskaCluster previous))
                _cluster = previous;
            _gap = block.ElementOffset;
            _behindTop = (_behindTop + MaxRemembered - 1) % MaxRemembered;
            _behindCount--;
            _next = block;
            _nextCluster = _cluster;
            _nextIsKnown = true;
            _hasNext = true;
        }

        private void Place(in MatroskaCluster cluster)
        {
            _cluster = cluster;
            _gap = cluster.DataOffset;
            _behindCount = 0;
            _isAtStart = false;
            _nextIsKnown = false;
        }

        private void Remember(in MatroskaBlock block)
        {
            _behindTop = (_behindTop + 1) % MaxRemembered;
            (_behind ??= new MatroskaBlock[MaxRemembered])[_behindTop] = block;
            _behindCount = Math.Min(_behindCount + 1, MaxRemembered);
            _isAtStart = false;
        }

        private bool FindNext()
        {
            if (!_hasCluster)
                return false;
            if (_gap >= _emptyAheadFrom && _gap <= _emptyAheadTo)
            {
                _next = _afterEmpty;
                _nextCluster = _afterEmptyCluster;
                if (_emptyAheadTo == long.MaxValue)
                    return false;
                _clusters.Verify(ref _nextCluster);
                _next.IsSuspect = _nextCluster.ChecksumMismatch;
                return true;
            }

            bool isFound = SearchAhead();
            long end = isFound ? _next.ElementOffset : long.MaxValue;
            if ((!isFound || _nextCluster.Offset != _cluster.Offset) && end - _gap > _emptyAheadTo - _emptyAheadFrom)
            {
                _emptyAheadFrom = _gap;
                _emptyAheadTo = end;
                _afterEmpty = _next;
                _afterEmptyCluster = _nextCluster;
            }

            return isFound;
        }

        private bool SearchAhead()
        {
            _clusters.Verify(ref _cluster);
            _nextCluster = _cluster;
            long position = _gap;
            while (true)
            {
                while (position < _nextCluster.BlocksEnd
                    && _reader.TryReadElement(position, _nextCluster.BlocksEnd, out EbmlElement element))
                {
                    if (_parser.TryParse(_nextCluster, element, out _next))
                        return true;
                    position = element.End;
                }

                if (!_clusters.TryNext(_nextCluster, out MatroskaCluster next))
                    return false;
                _clusters.Verify(ref next);
                _nextCluster = next;
                position = next.DataOffset;
            }
        }

        private void FindPrevious()
        {
            if (!_hasCluster)
                return;
            if (_gap >= _emptyBehindFrom && _gap <= _emptyBehindTo)
            {
                if (_emptyBehindFrom > 0)
                    Remember(_beforeEmpty);
                return;
            }

            bool isFound = SearchBehind();
            long start = isFound ? _behind![_behindTop].ElementEnd : 0;
            if ((!isFound || _behind![_behindTop].ClusterOffset != _cluster.Offset) && _gap - start > _emptyBehindTo - _emptyBehindFrom)
            {
                _emptyBehindFrom = start;
                _emptyBehindTo = _gap;
                _beforeEmpty = isFound ? _behind![_behindTop] : default;
            }
        }

        private bool SearchBehind()
        {
            _clusters.Verify(ref _cluster);
            MatroskaCluster cluster = _cluster;
            long end = _gap;
            while (true)
            {
                long position = cluster.DataOffset;
                while (position < end && _reader.TryReadElement(position, end, out EbmlElement element))
                {
                    if (_parser.TryParse(cluster, element, out MatroskaBlock block))
                        Remember(block);
                    position = element.End;
                }

                if (_behindCount > 0 || !_clusters.TryPrevious(cluster, out MatroskaCluster previous))
                    return _behindCount > 0;
                _clusters.Verify(ref previous);
                cluster = previous;
                end = cluster.BlocksEnd;
            }
        }
    }
}
