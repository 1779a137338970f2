using System;
using System.Buffers.Binary;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>Reads the heads of one track's blocks, plain or in a group.</summary>
    internal sealed class BlockParser
    {
        /// <summary>In place of a track number: blocks of every track.</summary>
        public const long AnyTrack = -1;

        private readonly EbmlReader _reader;
        private readonly ProblemLog _problems;
        private readonly long _track;
        private readonly long _timecodeScale;

        public BlockParser(EbmlReader reader, ProblemLog problems, long track, long timecodeScale)
        {
            _reader = reader;
            _problems = problems;
            _track = track;
            _timecodeScale = timecodeScale;
        }

        /// <summary>True when the element is a block of this track.</summary>
        public bool TryParse(in MatroskaCluster cluster, in EbmlElement element, out MatroskaBlock block)
        {
            block = default;
            EbmlElement body = element;
            if (element.Id == MatroskaIds.BlockGroup)
            {
                var children = new EbmlChildren(_reader, element, cluster.BlocksEnd);
                body = default;
                while (children.MoveNext())
                {
                    EbmlElement child = children.Current;
                    if (child.Id == MatroskaIds.Block && body.Id == 0)
                        body = child;
                    else if (child.Id == MatroskaIds.BlockDuration && _reader.TryReadUnsigned(child, out ulong duration)
                        && duration <= (ulong)((1L << 56) / _timecodeScale))
                        block.DurationNs = (long)duration * _timecodeScale;
                }

                if (children.IsDamaged && body.Id == 0)
                    Report(element.Offset, "this block group is damaged and is lost");
            }
            else if (element.Id != MatroskaIds.SimpleBlock)
            {
                return false;
            }

            return body.Id != 0 && TryParseHead(cluster, element, body, ref block);
        }

        private bool TryParseHead(in MatroskaCluster cluster, in EbmlElement element, in EbmlElement body, ref MatroskaBlock block)
        {
            Span<byte> head = stackalloc byte[11];
            head = head.Slice(0, _reader.Peek(body.DataOffset, head.Slice(0, (int)Math.Min(11, body.Size))));
            if (!EbmlVarint.TryReadSize(head, out long track, out int length) || head.Length < length + 3 || body.Size > int.MaxValue)
            {
                Report(element.Offset, "this block's head is damaged; the block is lost");
                return false;
            }

            if (track != _track && _track != AnyTrack)
                return false;
            block.ElementOffset = element.Offset;
            block.ElementEnd = element.End;
            block.ClusterOffset = cluster.Offset;
            block.Track = track;
            block.TimeNs = cluster.TimeNs + BinaryPrimitives.ReadInt16BigEndian(head.Slice(length)) * _timecodeScale;
            block.Lacing = (BlockLacingKind)((head[length + 2] >> 1) & 3);
            block.PayloadOffset = body.DataOffset + length + 3;
            block.PayloadSize = (int)body.Size - length - 3;
            block.IsSuspect = cluster.ChecksumMismatch;
            return true;
        }

        private void Report(long offset, string what)
        {
            if (_problems.Accepts(offset))
                _problems.Add(offset, what);
        }
    }
}
