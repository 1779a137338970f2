using System;
using System.Collections.Generic;
using System.IO;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// A Matroska file open for reading: its header elements at once, its blocks through cursors. Reads over damage wherever
    /// something whole is left behind it and notes it. One thread at a time.
    /// </summary>
    internal sealed class MatroskaFile
    {
        private const string Remedy = "choose another file, or copy this one again from where it was recorded";

        private readonly EbmlReader _reader;
        private readonly ProblemLog _problems;
        private readonly string _name;
        private readonly MatroskaHeader _header;
        private readonly ClusterIndex _index = new ClusterIndex();
        private readonly List<EbmlElement> _lateElements = new List<EbmlElement>();

        private long _segmentData;
        private long _segmentEnd;
        private long _seekHeadOffset = -1;
        private bool _isOpenEnded;
        private bool _isCut;

        /// <param name="stream">Seekable; stays the caller's to dispose.</param>
        /// <param name="name">For messages.</param>
        /// <param name="problems">Takes what is found damaged now and later.</param>
        /// <exception cref="InputException">The file is empty, not Matroska, or holds no cluster.</exception>
        public MatroskaFile(Stream stream, string name, ProblemLog problems)
        {
            _name = name;
            _problems = problems;
            _reader = new EbmlReader(stream);
            _header = new MatroskaHeader(_reader, problems);
            long position = ReadEbmlHead();
            FindSegment(position);
            long firstCluster = ReadUntilFirstCluster();
            bool hasCues = ReadSeekTargets();
            if (_isOpenEnded && !hasCues)
            {
                _isCut = true;
                _problems.Add(_segmentData, "the recorder was stopped before it could finish this file (open-ended segment without cues); read to the end of the file");
            }

            if (firstCluster < 0)
            {
                throw new InputException(_name, _isCut
                    ? "the file is cut off at byte " + _reader.Length + ", before its first cluster: it holds no frames"
                    : "holds no frames (no cluster in " + _reader.Length + " bytes)", Remedy);
            }

            var scanner = new ClusterScanner(_reader, problems, _segmentEnd, _header.TimecodeScale);
            scanner.OtherElementFound = NoteLateElement;
            Clusters = new ClusterMap(scanner, _index, firstCluster);
            if (!hasCues)
                _index.Clear();
            WalkToEnd();
            foreach (EbmlElement element in _lateElements)
                _header.Read(element, _segmentEnd);
            IsCut = _isCut | scanner.IsCut;
        }

        public ClusterMap Clusters { get; }

        public EbmlReader Reader => _reader;

        /// <summary>The end of the recording is missing: the file is cut, or its recorder was stopped before it could finish.</summary>
        public bool IsCut { get; }

        public long TimecodeScale => _header.TimecodeScale;

        public IReadOnlyList<MatroskaTrack> Tracks => _header.Tracks;

        public IReadOnlyList<MatroskaTag> Tags => _header.Tags;

        public IReadOnlyList<MatroskaAttachment> Attachments => _header.Attachments;

        /// <summary>Time of the last block, with its duration less one, in nanoseconds; found in the last cluster that has blocks.</summary>
        public long LastTimeNs { get; private set; }

        public BlockCursor CreateCursor(long track) => new BlockCursor(_reader, Clusters, _problems, track, TimecodeScale);

        private long ReadEbmlHead()
        {
            if (_reader.Length == 0)
                throw new InputException(_name, "the file is empty", Remedy);
            if (!_reader.TryReadElement(0, _reader.Length, out EbmlElement head) || head.Id != MatroskaIds.EbmlHead)
                throw new InputException(_name, "not a Matroska file (byte 0 is not an EBML head)", "give a recording (.mkv)");
            if (head.End > _reader.Length)
                throw new InputException(_name, "the file is cut off inside its first element, at byte " + _reader.Length, Remedy);
            var children = new EbmlChildren(_reader, head, _reader.Length);
            while (children.MoveNext())
            {
                EbmlElement child = children.Current;
                if (child.Id == MatroskaIds.DocType)
                {
                    string type = _reader.ReadString(child);
                    if (type != "matroska" && type != "webm")
                        throw new InputException(_name, "an EBML file, but its document type is not Matroska (byte " + child.Offset + ")", "give a recording (.mkv)");
                    continue;
                }

                if (!_reader.TryReadUnsigned(child, out ulong value))
                    continue;
                if (child.Id == MatroskaIds.EbmlReadVersion && value > 1 || child.Id == MatroskaIds.DocTypeReadVersion && value > 4
                    || child.Id == MatroskaIds.EbmlMaxIdLength && value > 4 || child.Id == MatroskaIds.EbmlMaxSizeLength && value > 8)
                    throw new InputException(_name, "asks for a newer Matroska reader (byte " + child.Offset + ")", "remux it with mkvmerge");
            }

            return head.End;
        }

        private void FindSegment(long position)
        {
            EbmlElement segment;
            while (_reader.TryReadElement(position, _reader.Length, out segment) && segment.Id != MatroskaIds.Segment && segment.End < _reader.Length)
                position = segment.End;
            if (segment.Id != MatroskaIds.Segment)
                throw new InputException(_name, "holds no Matroska segment (none at byte " + position + ")", Remedy);
            _segmentData = segment.DataOffset;
            _segmentEnd = _reader.Length;
            _isOpenEnded = !segment.SizeIsKnown;
            if (segment.Size == 0)
            {
                _isCut = true;
                _problems.Add(segment.Offset, "the recorder was stopped before it could finish this file (segment size 0); read to the end of the file");
            }
            else if (segment.SizeIsKnown && segment.End > _reader.Length)
            {
                _isCut = true;
                _problems.Add(segment.Offset, "the file is cut off: its segment should reach byte " + segment.End + ", the file ends at " + _reader.Length);
            }
            else if (segment.SizeIsKnown)
            {
                _segmentEnd = segment.End;
            }
        }

        /// <summary>Offset of the first cluster, or -1.</summary>
        private long ReadUntilFirstCluster()
        {
            long position = _segmentData;
            while (position < _segmentEnd)
            {
                if (!_reader.TryReadElement(position, _segmentEnd, out EbmlElement element) || element.Id != MatroskaIds.Cluster && element.End > _segmentEnd)
                {
                    if (element.Id != 0)
                        _header.Read(element, _segmentEnd);
                    _problems.Add(position, "the header is damaged or cut here; the first cluster is searched for");
                    return new ClusterScanner(_reader, _problems, _segmentEnd, TimecodeScale).Search(position + 1);
                }

                if (element.Id == MatroskaIds.Cluster)
                    return position;
                if (element.Id == MatroskaIds.SeekHead && _seekHeadOffset < 0)
                    _seekHeadOffset = position;
                _header.Read(element, _segmentEnd);
                position = element.End;
            }

            return -1;
        }

        /// <summary>Reads what the table of contents points at and what was not yet met. True when there are usable cues.</summary>
        private bool ReadSeekTargets()
        {
            if (_seekHeadOffset < 0 || !_reader.TryReadElement(_seekHeadOffset, _segmentEnd, out EbmlElement seekHead))
                return false;
            bool hasCues = false;
            var entries = new EbmlChildren(_reader, seekHead, _segmentEnd);
            while (entries.MoveNext())
            {
                if (entries.Current.Id != MatroskaIds.Seek)
                    continue;
                long position = -1;
                var fields = new EbmlChildren(_reader, entries.Current, entries.Current.End);
                while (fields.MoveNext())
                {
                    if (fields.Current.Id == MatroskaIds.SeekPosition && _reader.TryReadUnsigned(fields.Current, out ulong value)
                        && value < (ulong)(_segmentEnd - _segmentData))
                        position = _segmentData + (long)value;
                }

                if (position < 0 || !_reader.TryReadElement(position, _segmentEnd, out EbmlElement target))
                    continue;
                if (target.Id == MatroskaIds.Cues)
                    hasCues |= ReadCues(target);
                else if (target.Id == MatroskaIds.Tags || target.Id == MatroskaIds.Attachments || target.Id == MatroskaIds.Tracks || target.Id == MatroskaIds.Info)
                    _header.Read(target, _segmentEnd);
            }

            return hasCues;
        }

        private bool ReadCues(in EbmlElement cues)
        {
            var points = new EbmlChildren(_reader, cues, _segmentEnd);
            while (points.MoveNext())
            {
                if (points.Current.Id != MatroskaIds.CuePoint)
                    continue;
                long time = -1;
                long position = -1;
                var fields = new EbmlChildren(_reader, points.Current, points.Current.End);
                while (fields.MoveNext())
                {
                    if (fields.Current.Id == MatroskaIds.CueTime && _reader.TryReadUnsigned(fields.Current, out ulong value)
                        && value <= (ulong)((1L << 61) / TimecodeScale))
                        time = (long)value * TimecodeScale;
                    else if (fields.Current.Id == MatroskaIds.CueTrackPositions)
                        position = ReadCuePosition(fields.Current);
                }

                if (time >= 0 && position >= 0)
                    _index.Add(position, time);
            }

            // One look tells whether the file was changed without its cues; a single bad cue is dropped when it is used.
            return _index.Count > 0
                && _reader.TryReadElement(_index.OffsetOf(_index.Count - 1), _segmentEnd, out EbmlElement last)
                && last.Id == MatroskaIds.Cluster;
        }

        private long ReadCuePosition(in EbmlElement positions)
        {
            var fields = new EbmlChildren(_reader, positions, positions.End);
            while (fields.MoveNext())
            {
                if (fields.Current.Id == MatroskaIds.CueClusterPosition && _reader.TryReadUnsigned(fields.Current, out ulong value)
                    && value < (ulong)(_segmentEnd - _segmentData))
                    return _segmentData + (long)value;
            }

            return -1;
        }

        private void NoteLateElement(EbmlElement element)
        {
            // The time unit is in use by now; it must not change under the readers.
            if (_lateElements.Count < 16 && element.Id != MatroskaIds.Info)
                _lateElements.Add(element);
        }

        /// <summary>Finds the last cluster (through the cues, or over all clusters) and the time of the last block.</summary>
        private void WalkToEnd()
        {
            if (!Clusters.TryLast(out MatroskaCluster cluster))
                return;
            BlockCursor cursor = CreateCursor(BlockParser.AnyTrack);
            for (int i = 0; i < 8; i++)
            {
                long last = LastTimeIn(cluster, cursor);
                if (last != long.MinValue)
                {
                    LastTimeNs = Math.Max(0, last);
                    return;
                }

                if (!Clusters.TryPrevious(cluster, out MatroskaCluster previous))
                    return;
                cluster = previous;
            }
        }

        private static long LastTimeIn(in MatroskaCluster cluster, BlockCursor cursor)
        {
            long last = long.MinValue;
            cursor.PlaceAt(cluster);
            while (cursor.TryPeekNext(out MatroskaBlock block) && block.ClusterOffset == cluster.Offset)
            {
                last = Math.Max(last, block.TimeNs + Math.Max(0, block.DurationNs - 1));
                cursor.MoveNext();
            }

            return last;
        }
    }
}
