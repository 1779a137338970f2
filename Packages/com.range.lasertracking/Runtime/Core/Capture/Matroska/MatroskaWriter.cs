using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// Writes a Matroska file as the Azure Kinect recorder lays it out (time unit 1 µs, clusters of at most 32 ms with a checksum).
    /// Each cluster goes out in one piece; until <see cref="Finish"/> the segment is open-ended, so that a file whose writer was
    /// killed reads to its last byte. Not thread-safe; allocates nothing once warm but for the cues, 24 bytes a second.
    /// </summary>
    internal sealed class MatroskaWriter
    {
        private const int SeekHeadRoom = 1024;
        private const int InfoRoom = 256;
        private const long ClusterSpanUs = 32000;
        private const long CueSpacingUs = 1000000;
        private const int MaxClusterBytes = 1 << 30;

        private readonly Stream _stream;
        private readonly MatroskaHead _head;
        private readonly EbmlWriter _cluster = new EbmlWriter();
        private readonly EbmlWriter _other = new EbmlWriter();
        private readonly List<(long TimeUs, long Position)> _cues = new List<(long, long)>(1024);
        private readonly List<(uint Id, long Position)> _contents = new List<(uint, long)>();
        private long _segmentData = -1;
        private long _infoOffset;
        private int _clusterBegun;
        private int _checksumAt;
        private bool _clusterHasFirstTrack;
        private long _clusterTimeUs;
        private long _endUs;

        /// <param name="stream">Writable and seekable, at its beginning; stays the caller's.</param>
        /// <param name="head">Written with the first cluster: until then it may be changed.</param>
        public MatroskaWriter(Stream stream, MatroskaHead head)
        {
            _stream = stream;
            _head = head;
        }

        /// <summary>Bytes of the file that are whole, counted from its beginning.</summary>
        public long WrittenBytes { get; private set; }

        /// <summary>
        /// Adds a block and returns the room for its payload, which must be filled before the next call. Times may go back: what lies
        /// too far from its cluster's time opens another one.
        /// </summary>
        /// <param name="track">Number of the track.</param>
        /// <param name="timeUs">From the start of the recording; not negative.</param>
        /// <param name="size">Bytes of the payload, lacing head included.</param>
        /// <param name="lacing">How the payload is divided.</param>
        /// <param name="durationUs">0: not told.</param>
        public Span<byte> AddBlock(long track, long timeUs, int size, BlockLacingKind lacing = BlockLacingKind.None, long durationUs = 0)
        {
            long relative = timeUs - _clusterTimeUs;
            if (_cluster.Length > 0 && (relative > ClusterSpanUs || relative < -ClusterSpanUs || (long)_cluster.Length + size > MaxClusterBytes))
                Flush();
            if (_cluster.Length == 0)
                BeginCluster(timeUs);
            int trackLength = EbmlVarint.SizeLengthOf(track);
            int blockSize = trackLength + 3 + size;
            bool isGroup = durationUs > 0;
            int group = isGroup ? _cluster.Begin(MatroskaIds.BlockGroup) : 0;
            // The duration stands first, so that the payload can be filled in last.
            if (isGroup)
                _cluster.Unsigned(MatroskaIds.BlockDuration, (ulong)durationUs);
            _cluster.Head(isGroup ? MatroskaIds.Block : MatroskaIds.SimpleBlock, blockSize);
            EbmlVarint.WriteSize(_cluster.Add(trackLength), track);
            Span<byte> head = _cluster.Add(3);
            BinaryPrimitives.WriteInt16BigEndian(head, (short)(timeUs - _clusterTimeUs));
            head[2] = (byte)((isGroup ? 0 : 0x80) | ((int)lacing << 1));
            _clusterHasFirstTrack |= track == _head.Tracks[0].Number;
            _endUs = Math.Max(_endUs, timeUs + Math.Max(durationUs, PeriodUs(track)));
            int payload = _cluster.Length;
            _cluster.Add(size);
            if (isGroup)
                _cluster.End(group);
            return _cluster.At(payload, size);
        }

        /// <summary>Hands everything so far to the stream, in one piece.</summary>
        public void Flush()
        {
            if (_cluster.Length == 0)
                return;
            _cluster.End(_clusterBegun);
            BinaryPrimitives.WriteUInt32LittleEndian(_cluster.At(_checksumAt, 4), Crc32.Append(0, _cluster.Written.Slice(_checksumAt + 4)));
            if (_segmentData < 0)
                WriteHead();
            long position = _stream.Position;
            if (_clusterHasFirstTrack && (_cues.Count == 0 || _clusterTimeUs - _cues[_cues.Count - 1].TimeUs >= CueSpacingUs))
                _cues.Add((_clusterTimeUs, position - _segmentData));
            Write(_cluster);
            _cluster.Clear();
        }

        /// <summary>Writes the cues, then what can only be known now: table of contents, duration, the segment's size. To be called once.</summary>
        public void Finish()
        {
            Flush();
            if (_segmentData < 0)
                WriteHead();
            WriteCues();
            WriteSizes();
        }

        /// <summary>
        /// The same after the stream refused bytes (a full disk): drops what is not whole and finishes without cues, in place.
        /// </summary>
        public void FinishAfterFailure()
        {
            if (_segmentData < 0)
                return;
            _stream.SetLength(WrittenBytes);
            WriteSizes();
        }

        private void BeginCluster(long timeUs)
        {
            _clusterTimeUs = timeUs;
            _clusterHasFirstTrack = false;
            _clusterBegun = _cluster.Begin(MatroskaIds.Cluster);
            _cluster.Head(MatroskaIds.Crc32, 4);
            _checksumAt = _cluster.Length;
            _cluster.Add(4);
            _cluster.Unsigned(MatroskaIds.Timecode, (ulong)timeUs);
        }

        private void WriteHead()
        {
            _other.Clear();
            _head.WriteFileHead(_other);
            int segmentData = _other.Length;
            long origin = _stream.Position;
            _other.Void(SeekHeadRoom);
            Note(MatroskaIds.Info, segmentData);
            _infoOffset = origin + _other.Length;
            WriteInfo(null);
            Note(MatroskaIds.Tracks, segmentData);
            _head.WriteTracks(_other);
            if (_head.Attachments.Count > 0)
            {
                Note(MatroskaIds.Attachments, segmentData);
                _head.WriteAttachments(_other);
            }

            if (_head.Tags.Count > 0)
            {
                Note(MatroskaIds.Tags, segmentData);
                _head.WriteTags(_other);
            }

            // Known before the bytes are out: whoever cleans up after a failure needs it.
            _segmentData = origin + segmentData;
            Write(_other);
        }

        private void Note(uint id, int segmentData) => _contents.Add((id, _other.Length - segmentData));

        private void WriteInfo(double? durationUs)
        {
            int start = _other.Length;
            _head.WriteInfo(_other, durationUs);
            _other.Void(InfoRoom - (_other.Length - start));
        }

        private void WriteCues()
        {
            if (_cues.Count == 0)
                return;
            _contents.Add((MatroskaIds.Cues, _stream.Position - _segmentData));
            _other.Clear();
            int cues = _other.Begin(MatroskaIds.Cues);
            foreach ((long timeUs, long position) in _cues)
            {
                int point = _other.Begin(MatroskaIds.CuePoint);
                _other.Unsigned(MatroskaIds.CueTime, (ulong)timeUs);
                int place = _other.Begin(MatroskaIds.CueTrackPositions);
                _other.Unsigned(MatroskaIds.CueTrack, (ulong)_head.Tracks[0].Number);
                _other.Unsigned(MatroskaIds.CueClusterPosition, (ulong)position);
                _other.End(place);
                _other.End(point);
            }

            _other.End(cues);
            Write(_other);
        }

        private void WriteSizes()
        {
            _other.Clear();
            int seekHead = _other.Begin(MatroskaIds.SeekHead);
            foreach ((uint id, long position) in _contents)
            {
                int entry = _other.Begin(MatroskaIds.Seek);
                _other.IdAsData(MatroskaIds.SeekId, id);
                _other.Unsigned(MatroskaIds.SeekPosition, (ulong)position);
                _other.End(entry);
            }

            _other.End(seekHead);
            _other.Void(SeekHeadRoom - _other.Length);
            WriteInfo(_endUs);
            WriteAt(_segmentData, _other.Written);
            Span<byte> size = stackalloc byte[8];
            EbmlVarint.WriteSize(size, WrittenBytes - _segmentData);
            WriteAt(_segmentData - 8, size);
            _stream.Position = WrittenBytes;
        }

        private void WriteAt(long offset, ReadOnlySpan<byte> bytes)
        {
            _stream.Position = offset;
            _stream.Write(bytes);
        }

        private void Write(EbmlWriter content)
        {
            _stream.Write(content.Written);
            WrittenBytes = _stream.Position;
        }

        private long PeriodUs(long track)
        {
            foreach (MatroskaTrack candidate in _head.Tracks)
            {
                if (candidate.Number == track)
                    return candidate.DefaultDurationNs / 1000;
            }

            return 0;
        }
    }
}
