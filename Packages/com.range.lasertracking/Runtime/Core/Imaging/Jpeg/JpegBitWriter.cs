using System;

namespace LaserTracking.Imaging
{
    /// <summary>Collects bytes and entropy-coded bits; puts a zero behind each FF among the latter. Its memory is used again.</summary>
    internal sealed class JpegBitWriter
    {
        private byte[] _bytes = new byte[64 * 1024];
        private ulong _bits;
        private int _count;

        public int Length { get; private set; }

        public ReadOnlySpan<byte> Written => new ReadOnlySpan<byte>(_bytes, 0, Length);

        public void Clear()
        {
            Length = 0;
            _bits = 0;
            _count = 0;
        }

        public void Byte(int value)
        {
            if (Length == _bytes.Length)
                Array.Resize(ref _bytes, Length * 2);
            _bytes[Length++] = (byte)value;
        }

        public void BigEndian16(int value)
        {
            Byte(value >> 8);
            Byte(value);
        }

        public void Bytes(ReadOnlySpan<byte> values)
        {
            for (int i = 0; i < values.Length; i++)
                Byte(values[i]);
        }

        /// <summary>The lowest <paramref name="count"/> bits, at most 32, the highest of them first.</summary>
        public void Bits(int value, int count)
        {
            if (_count + count > 64)
                Drain();
            _bits = _bits << count | ((uint)value & ((1UL << count) - 1));
            _count += count;
        }

        /// <summary>Fills the last byte with ones and ends the entropy-coded run.</summary>
        public void Flush()
        {
            Drain();
            if (_count > 0)
                Bits(0x7F, 8 - _count);
            Drain();
        }

        private void Drain()
        {
            if (Length + 16 > _bytes.Length)
                Array.Resize(ref _bytes, _bytes.Length * 2);
            while (_count >= 8)
            {
                _count -= 8;
                byte next = (byte)(_bits >> _count);
                _bytes[Length++] = next;
                if (next == 0xFF)
                    _bytes[Length++] = 0;
            }
        }
    }
}
