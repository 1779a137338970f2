namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// Finds clusters one after another, forwards and backwards, over damage. A cluster ends where its size says, where another
    /// top-level element begins, at the first child that makes no sense, or with the file; the next one is then taken from the
    /// declared size if a cluster stands there, and searched for otherwise.
    /// </summary>
    internal sealed class ClusterMap
    {
        private const int CacheSize = 64;
        private const int IndexSpacing = 32;

        private readonly ClusterScanner _scanner;
        private readonly ClusterIndex _index;
        private readonly long _firstOffset;
        private readonly MatroskaCluster[] _cache = new MatroskaCluster[CacheSize];
        private int _cached;

        public ClusterMap(ClusterScanner scanner, ClusterIndex index, long firstOffset)
        {
            _scanner = scanner;
            _index = index;
            _firstOffset = firstOffset;
        }

        /// <summary>Checks each cluster's CRC-32 when a reader enters it. Costs one more read of the whole cluster.</summary>
        public bool VerifiesChecksums { get; set; }

        public bool TryFirst(out MatroskaCluster cluster) => TryGet(_firstOffset, out cluster);

        public bool TryNext(in MatroskaCluster cluster, out MatroskaCluster next)
        {
            next = default;
            return cluster.NextOffset > cluster.Offset && TryGet(cluster.NextOffset, out next);
        }

        public bool TryPrevious(in MatroskaCluster cluster, out MatroskaCluster previous)
        {
            for (int i = 0; i < CacheSize; i++)
            {
                if (_cache[i].NextOffset == cluster.Offset && _cache[i].Offset < cluster.Offset && _cache[i].DataOffset > 0)
                {
                    previous = _cache[i];
                    return true;
                }
            }

            previous = default;
            if (cluster.Offset <= _firstOffset || !TryGetIndexed(_index.LastBefore(cluster.Offset), out MatroskaCluster current))
                return false;
            return TryWalk(ref current, cluster.Offset, long.MaxValue) && Found(current, out previous);
        }

        /// <summary>The last cluster of the recording.</summary>
        public bool TryLast(out MatroskaCluster cluster)
        {
            if (!TryGetIndexed(_index.Count - 1, out cluster))
                return false;
            return TryWalk(ref cluster, long.MaxValue, long.MaxValue);
        }

        /// <summary>A cluster that begins at or before a time, at most a few before the last such one.</summary>
        public bool TryFind(long timeNs, out MatroskaCluster cluster)
        {
            // One entry earlier than the nearest, because a late block may stand in the cluster after its time.
            if (!TryGetIndexed(_index.LastNotAfter(timeNs) - 1, out MatroskaCluster current))
            {
                cluster = default;
                return false;
            }

            TryWalk(ref current, long.MaxValue, timeNs);
            return TryPrevious(current, out cluster) || Found(current, out cluster);
        }

        /// <summary>Verifies the checksum of a cluster that is about to be read, when that is wanted and was not done.</summary>
        public void Verify(ref MatroskaCluster cluster)
        {
            if (!VerifiesChecksums || cluster.ChecksumVerified)
                return;
            int at = IndexInCache(cluster.Offset);
            if (at >= 0 && _cache[at].ChecksumVerified)
            {
                cluster = _cache[at];
                return;
            }

            _scanner.Verify(ref cluster);
            if (at >= 0)
                _cache[at] = cluster;
        }

        private static bool Found(in MatroskaCluster cluster, out MatroskaCluster found)
        {
            found = cluster;
            return true;
        }

        /// <summary>Goes on to the last cluster that begins before an offset and not after a time, and notes places on the way.</summary>
        private bool TryWalk(ref MatroskaCluster current, long beforeOffset, long timeNs)
        {
            int steps = 0;
            while (TryNext(current, out MatroskaCluster next) && next.Offset < beforeOffset && next.TimeNs <= timeNs)
            {
                current = next;
                if (++steps % IndexSpacing == 0)
                    _index.Add(current.Offset, current.TimeNs);
            }

            return true;
        }

        private bool TryGetIndexed(int entry, out MatroskaCluster cluster)
        {
            for (; entry >= 0; entry--)
            {
                if (TryGet(_index.OffsetOf(entry), out cluster))
                    return true;
                _index.RemoveAt(entry);
            }

            return TryFirst(out cluster);
        }

        private bool TryGet(long offset, out MatroskaCluster cluster)
        {
            int at = IndexInCache(offset);
            if (at >= 0)
            {
                cluster = _cache[at];
                return true;
            }

            if (!_scanner.TryScan(offset, out cluster))
                return false;
            _cache[_cached] = cluster;
            _cached = (_cached + 1) % CacheSize;
            return true;
        }

        private int IndexInCache(long offset)
        {
            for (int i = 0; i < CacheSize; i++)
            {
                if (_cache[i].Offset == offset && _cache[i].DataOffset > 0)
                    return i;
            }

            return -1;
        }
    }
}
