using System;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>Walks the children of one cluster, finds where the next one begins, and searches for one behind damage.</summary>
    internal sealed class ClusterScanner
    {
        private const int ChunkSize = 1 << 16;
        private const long MaxTimeNs = 1L << 61;

        private static readonly byte[] ClusterId = { 0x1F, 0x43, 0xB6, 0x75 };

        private readonly EbmlReader _reader;
        private readonly ProblemLog _problems;
        private readonly long _segmentEnd;
        private readonly long _timecodeScale;
        private byte[]? _chunk;

        public ClusterScanner(EbmlReader reader, ProblemLog problems, long segmentEnd, long timecodeScale)
        {
            _reader = reader;
            _problems = problems;
            _segmentEnd = segmentEnd;
            _timecodeScale = timecodeScale;
        }

        /// <summary>The file ends inside an element.</summary>
        public bool IsCut { get; private set; }

        /// <summary>Called with each element that stands between or behind the clusters.</summary>
        public Action<EbmlElement>? OtherElementFound { get; set; }

        /// <summary>False when no cluster stands there.</summary>
        public bool TryScan(long offset, out MatroskaCluster cluster)
        {
            cluster = default;
            if (!_reader.TryReadElement(offset, _segmentEnd, out EbmlElement element) || element.Id != MatroskaIds.Cluster)
                return false;
            cluster.Offset = offset;
            cluster.DataOffset = element.DataOffset;
            cluster.ChecksumStart = -1;
            cluster.TimeNs = long.MinValue;
            cluster.DeclaredEnd = element.SizeIsKnown && element.End <= _segmentEnd ? element.End : -1;
            long end = WalkChildren(ref cluster, cluster.DataOffset, out string? damage);
            if (damage == null && end == cluster.DeclaredEnd && IsClusterChildAt(end))
            {
                Report(offset, "this cluster is longer than its size says; its blocks are used as far as they are whole");
                cluster.DeclaredEnd = -1;
                end = WalkChildren(ref cluster, end, out damage);
            }

            cluster.BlocksEnd = end;
            if (cluster.TimeNs == long.MinValue)
            {
                cluster.TimeNs = 0;
                cluster.BlocksEnd = cluster.DataOffset;
                Report(offset, "this cluster has no usable time; its blocks are lost");
            }

            if (damage == null)
                cluster.NextOffset = FindNext(end);
            else if (cluster.DeclaredEnd >= 0 && IsTopLevelAt(cluster.DeclaredEnd))
                cluster.NextOffset = FindNext(cluster.DeclaredEnd);
            else
                cluster.NextOffset = Search(end + 1);
            if (damage != null)
                ReportDamage(cluster, end, damage);
            return true;
        }

        /// <summary>Offset of the first cluster at or behind an offset, or -1. Reads on to the end of the file if need be.</summary>
        public long Search(long offset)
        {
            byte[] chunk = _chunk ??= new byte[(int)Math.Min(ChunkSize, _reader.Length)];
            while (offset < _segmentEnd)
            {
                Span<byte> bytes = chunk.AsSpan(0, (int)Math.Min(chunk.Length, _segmentEnd - offset));
                if (bytes.Length < ClusterId.Length || !_reader.TryRead(offset, bytes))
                    return -1;
                int at = bytes.IndexOf(ClusterId);
                if (at < 0)
                {
                    offset += bytes.Length - (ClusterId.Length - 1);
                    if (bytes.Length < chunk.Length)
                        return -1;
                    continue;
                }

                if (IsClusterAt(offset + at))
                    return offset + at;
                offset += at + 1;
            }

            return -1;
        }

        /// <summary>Compares the stored checksum with the bytes and reports a difference; the data stays in use.</summary>
        public void Verify(ref MatroskaCluster cluster)
        {
            cluster.ChecksumVerified = true;
            if (cluster.ChecksumStart < 0 || cluster.DeclaredEnd < cluster.ChecksumStart)
                return;
            byte[] chunk = _chunk ??= new byte[(int)Math.Min(ChunkSize, _reader.Length)];
            uint crc = 0;
            for (long offset = cluster.ChecksumStart; offset < cluster.DeclaredEnd;)
            {
                Span<byte> bytes = chunk.AsSpan(0, (int)Math.Min(chunk.Length, cluster.DeclaredEnd - offset));
                if (!_reader.TryRead(offset, bytes))
                    return;
                crc = Crc32.Append(crc, bytes);
                offset += bytes.Length;
            }

            cluster.ChecksumMismatch = crc != cluster.Checksum;
            if (cluster.ChecksumMismatch)
                Report(cluster.Offset, "the checksum of this cluster does not fit its bytes: data in it is damaged; it is used as it is");
        }

        /// <summary>Returns where the whole children end, and what stands there if that is not the cluster's proper end.</summary>
        private long WalkChildren(ref MatroskaCluster cluster, long position, out string? damage)
        {
            damage = null;
            long limit = cluster.DeclaredEnd >= 0 ? cluster.DeclaredEnd : _segmentEnd;
            while (position < limit)
            {
                if (!_reader.TryReadElement(position, limit, out EbmlElement child))
                {
                    damage = "here stands no element; the rest of this cluster is lost";
                    return position;
                }

                if (MatroskaIds.IsTopLevel(child.Id))
                {
                    if (cluster.DeclaredEnd >= 0)
                        Report(cluster.Offset, "this cluster is shorter than its size says; the next one is used from where it begins");
                    cluster.DeclaredEnd = -1;
                    return position;
                }

                if (child.End > limit)
                {
                    damage = "a block is larger than what is left of its cluster and is lost";
                    return position;
                }

                ReadChild(ref cluster, child);
                position = child.End;
            }

            return position;
        }

        private void ReadChild(ref MatroskaCluster cluster, in EbmlElement child)
        {
            if (child.Id == MatroskaIds.Timecode && cluster.TimeNs == long.MinValue)
            {
                if (_reader.TryReadUnsigned(child, out ulong time) && time <= (ulong)(MaxTimeNs / _timecodeScale))
                    cluster.TimeNs = (long)time * _timecodeScale;
            }
            else if (child.Id == MatroskaIds.Crc32 && child.Size == 4 && child.Offset == cluster.DataOffset)
            {
                Span<byte> bytes = stackalloc byte[4];
                if (!_reader.TryRead(child.DataOffset, bytes))
                    return;
                cluster.Checksum = System.Buffers.Binary.BinaryPrimitives.ReadUInt32LittleEndian(bytes);
                cluster.ChecksumStart = child.End;
            }
        }

        /// <summary>Skips what stands between clusters; over damage it searches.</summary>
        private long FindNext(long position)
        {
            while (position < _segmentEnd)
            {
                bool isElement = _reader.TryReadElement(position, _segmentEnd, out EbmlElement element);
                if (isElement && element.Id == MatroskaIds.Cluster)
                    return position;
                bool isKnown = isElement && (MatroskaIds.IsTopLevel(element.Id) || element.Id == MatroskaIds.Void || element.Id == MatroskaIds.Crc32);
                if (!isElement || element.End > _segmentEnd || !isKnown && !IsTopLevelAt(element.End))
                {
                    if (isKnown && element.SizeIsKnown)
                        IsCut = true;
                    Report(position, isKnown
                        ? "the file ends inside its " + MatroskaHeader.NameOf(element.Id)
                        : "here stands no element; the next cluster is searched for");
                    return Search(position + 1);
                }

                if (isKnown)
                    OtherElementFound?.Invoke(element);
                position = element.End;
            }

            return -1;
        }

        private bool IsTopLevelAt(long position) =>
            position >= _segmentEnd
            || _reader.TryReadElement(position, _segmentEnd, out EbmlElement element)
                && (MatroskaIds.IsTopLevel(element.Id) || element.Id == MatroskaIds.Void);

        private bool IsClusterAt(long position) =>
            _reader.TryReadElement(position, _segmentEnd, out EbmlElement element)
            && (!_reader.TryReadElement(element.DataOffset, _segmentEnd, out EbmlElement child)
                ? element.Size == 0 || element.DataOffset == _segmentEnd
                : MatroskaIds.MayBeginCluster(child.Id));

        /// <summary>Something stands there that only a cluster holds.</summary>
        private bool IsClusterChildAt(long position)
        {
            if (!_reader.TryReadElement(position, _segmentEnd, out EbmlElement element) || element.End > _segmentEnd)
                return false;
            if (element.Id == MatroskaIds.Crc32)
                return _reader.TryReadElement(element.End, _segmentEnd, out EbmlElement next) && next.Id == MatroskaIds.Timecode;
            return element.Id == MatroskaIds.SimpleBlock || element.Id == MatroskaIds.BlockGroup || element.Id == MatroskaIds.Timecode;
        }

        private void ReportDamage(in MatroskaCluster cluster, long position, string damage)
        {
            bool isCut = cluster.DeclaredEnd < 0 && cluster.NextOffset < 0;
            IsCut |= isCut;
            Report(position, isCut
                ? "the file ends inside a cluster; everything whole before it is used"
                : damage + "; reading goes on at the next cluster");
        }

        private void Report(long offset, string what)
        {
            if (_problems.Accepts(offset))
                _problems.Add(offset, what);
        }
    }
}
