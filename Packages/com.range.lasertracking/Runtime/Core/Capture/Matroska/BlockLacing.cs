using System;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>Splits a block into its frames (RFC 9559, section 10.3). Holds its tables, so that splitting allocates nothing.</summary>
    internal sealed class BlockLacing
    {
        private const int MaxFrames = 256;

        private readonly long[] _offsets = new long[MaxFrames];
        private readonly int[] _sizes = new int[MaxFrames];

        /// <summary>Number of frames, 1 to 256, after a successful <see cref="TrySplit"/>.</summary>
        public int Count { get; private set; }

        public long OffsetOf(int frame) => _offsets[frame];

        public int SizeOf(int frame) => _sizes[frame];

        /// <summary>Finds the frames. False when the counts and sizes of the lacing do not fit into the payload.</summary>
        public bool TrySplit(EbmlReader reader, in MatroskaBlock block)
        {
            Count = 0;
            long position = block.PayloadOffset;
            long end = block.PayloadOffset + block.PayloadSize;
            if (block.Lacing == BlockLacingKind.None)
            {
                _offsets[0] = position;
                _sizes[0] = block.PayloadSize;
                Count = 1;
                return true;
            }

            if (!TryReadByte(reader, ref position, end, out byte last))
                return false;
            int count = last + 1;
            bool fits = block.Lacing switch
            {
                BlockLacingKind.Xiph => TryReadXiphSizes(reader, ref position, end, count),
                BlockLacingKind.Ebml => TryReadEbmlSizes(reader, ref position, end, count),
                _ => TryDivide(end - position, count),
            };
            if (!fits)
                return false;
            for (int i = 0; i < count; i++)
            {
                _offsets[i] = position;
                position += _sizes[i];
            }

            Count = count;
            return true;
        }

        private bool TryDivide(long size, int count)
        {
            if (size % count != 0)
                return false;
            Array.Fill(_sizes, (int)(size / count), 0, count);
            return true;
        }

        private bool TryReadXiphSizes(EbmlReader reader, ref long position, long end, int count)
        {
            long sum = 0;
            for (int i = 0; i < count - 1; i++)
            {
                long size = 0;
                byte part;
                do
                {
                    if (!TryReadByte(reader, ref position, end, out part))
                        return false;
                    size += part;
                }
                while (part == 0xFF);
                _sizes[i] = (int)size;
                sum += size;
            }

            return TryGiveRestToLast(end - position - sum, count);
        }

        private bool TryReadEbmlSizes(EbmlReader reader, ref long position, long end, int count)
        {
            Span<byte> bytes = stackalloc byte[8];
            long size = 0;
            long sum = 0;
            for (int i = 0; i < count - 1; i++)
            {
                Span<byte> head = bytes.Slice(0, (int)Math.Min(8, end - position));
                head = head.Slice(0, reader.Peek(position, head));
                if (!(i == 0
                        ? EbmlVarint.TryReadSize(head, out long value, out int length)
                        : EbmlVarint.TryReadSigned(head, out value, out length)))
                    return false;
                size = i == 0 ? value : size + value;
                position += length;
                sum += size;
                if (size < 0 || sum > end - position)
                    return false;
                _sizes[i] = (int)size;
            }

            return TryGiveRestToLast(end - position - sum, count);
        }

        private bool TryGiveRestToLast(long rest, int count)
        {
            if (rest < 0)
                return false;
            _sizes[count - 1] = (int)rest;
            return true;
        }

        private static bool TryReadByte(EbmlReader reader, ref long position, long end, out byte value)
        {
            Span<byte> one = stackalloc byte[1];
            value = 0;
            if (position >= end || reader.Peek(position, one) != 1)
                return false;
            value = one[0];
            position++;
            return true;
        }
    }
}
