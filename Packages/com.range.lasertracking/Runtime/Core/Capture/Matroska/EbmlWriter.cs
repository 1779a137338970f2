using System;
using System.Buffers.Binary;
using System.Text;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>Builds EBML elements in a buffer that grows on demand and is used again: nothing is allocated once warm.</summary>
    internal sealed class EbmlWriter
    {
        private byte[] _bytes = new byte[1024];

        public int Length { get; private set; }

        /// <summary>What was written so far; valid until the next call.</summary>
        public ReadOnlySpan<byte> Written => new ReadOnlySpan<byte>(_bytes, 0, Length);

        public void Clear() => Length = 0;

        /// <summary>Begins an element whose size is known later; returns what <see cref="End"/> needs. Its size takes 8 bytes.</summary>
        public int Begin(uint id)
        {
            Id(id);
            Add(8);
            return Length;
        }

        public void End(int begun) => EbmlVarint.WriteSize(_bytes.AsSpan(begun - 8, 8), Length - begun);

        /// <summary>The head of an element whose data follow, or are open-ended (<see cref="EbmlVarint.UnknownSize"/>, 8 bytes).</summary>
        public void Head(uint id, long size)
        {
            Id(id);
            EbmlVarint.WriteSize(Add(size == EbmlVarint.UnknownSize ? 8 : EbmlVarint.SizeLengthOf(size)), size);
        }

        public void Unsigned(uint id, ulong value)
        {
            int length = 1;
            while (length < 8 && value >> (8 * length) != 0)
                length++;
            Head(id, length);
            Span<byte> bytes = Add(length);
            for (int i = length - 1; i >= 0; i--, value >>= 8)
                bytes[i] = (byte)value;
        }

        public void Float(uint id, double value)
        {
            Head(id, 8);
            BinaryPrimitives.WriteInt64BigEndian(Add(8), BitConverter.DoubleToInt64Bits(value));
        }

        public void Text(uint id, string text) => Binary(id, Encoding.UTF8.GetBytes(text));

        public void Binary(uint id, ReadOnlySpan<byte> data)
        {
            Head(id, data.Length);
            data.CopyTo(Add(data.Length));
        }

        /// <summary>An id as an element's data: what tables of contents hold.</summary>
        public void IdAsData(uint id, uint value)
        {
            Head(id, LengthOf(value));
            Id(value);
        }

        /// <summary>An element without meaning that takes exactly so many bytes, at least 9.</summary>
        public void Void(int totalBytes)
        {
            int begun = Begin(MatroskaIds.Void);
            Add(totalBytes - 9).Clear();
            End(begun);
        }

        /// <summary>Room for so many bytes, to be filled at once; the next call may move it.</summary>
        public Span<byte> Add(int count)
        {
            if (Length + count > _bytes.Length)
                Array.Resize(ref _bytes, (int)Math.Min(int.MaxValue - 64, Math.Max(Length + (long)count, _bytes.Length * 3L / 2)));
            Span<byte> added = new Span<byte>(_bytes, Length, count);
            Length += count;
            return added;
        }

        /// <summary>Writes over what was written before.</summary>
        public Span<byte> At(int offset, int count) => new Span<byte>(_bytes, offset, count);

        private static int LengthOf(uint id) => id > 0xFFFFFF ? 4 : id > 0xFFFF ? 3 : id > 0xFF ? 2 : 1;

        private void Id(uint id)
        {
            int length = LengthOf(id);
            Span<byte> bytes = Add(length);
            for (int i = length - 1; i >= 0; i--, id >>= 8)
                bytes[i] = (byte)id;
        }
    }
}
