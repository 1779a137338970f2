using System;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// A Huffman code for decoding. Codes of up to <see cref="LookupBits"/> bits are found in one look-up that also answers with the
    /// coefficient itself where its bits fit in as well; longer ones by the canonical search of T.81 annex F.
    /// </summary>
    internal sealed class JpegHuffmanTable
    {
        public const int LookupBits = 10;

        /// <summary>Marks a look-up entry whose coefficient is included.</summary>
        public const int HasValue = 0x80;

        /// <summary>
        /// By the next 10 bits: 0 = longer code. Otherwise bits 0…6 = bits used up, bit 7 = <see cref="HasValue"/>, bits 8…15 =
        /// symbol (run of zeros in its upper half), bits 16…31 = the coefficient, signed, when it is included.
        /// </summary>
        public readonly int[] Lookup = new int[1 << LookupBits];

        /// <summary>By code length: first value that is too large to be a code of that length, aligned to 16 bits.</summary>
        private readonly int[] _limit = new int[18];

        private readonly int[] _offset = new int[17];
        private readonly byte[] _definition = new byte[16 + 256];
        private int _definitionLength;

        public JpegHuffmanTable()
        {
        }

        public JpegHuffmanTable(byte[] definition)
        {
            if (!TryBuild(definition))
                throw new ArgumentException("not a Huffman code", nameof(definition));
        }

        /// <summary>16 counts by code length, then the symbols. False when the counts do not describe a prefix code.</summary>
        public bool TryBuild(ReadOnlySpan<byte> definition)
        {
            // Cameras send the same tables with every frame.
            if (_definitionLength > 0 && definition.SequenceEqual(new ReadOnlySpan<byte>(_definition, 0, _definitionLength)))
                return true;

            _definitionLength = 0;
            Array.Clear(Lookup, 0, Lookup.Length);
            int code = 0;
            int symbolIndex = 16;
            for (int length = 1; length <= 16; length++)
            {
                int count = definition[length - 1];
                if (code + count > 1 << length || symbolIndex + count > definition.Length)
                    return false;
                _offset[length] = symbolIndex - code;
                for (int i = 0; i < count; i++, code++, symbolIndex++)
                {
                    if (length <= LookupBits)
                        FillLookup(code, length, definition[symbolIndex]);
                }

                _limit[length] = code << (16 - length);
                code <<= 1;
            }

            _limit[17] = int.MaxValue;
            definition.CopyTo(_definition);
            _definitionLength = definition.Length;
            return true;
        }

        /// <summary>Finds a code longer than the look-up. Returns length in bits 0…7 and symbol in bits 8…15, or -1: no such code.</summary>
        public int FindLong(int next16Bits)
        {
            int length = LookupBits + 1;
            while (next16Bits >= _limit[length])
                length++;
            if (length > 16)
                return -1;
            return length | _definition[_offset[length] + (next16Bits >> (16 - length))] << 8;
        }

        private void FillLookup(int code, int length, int symbol)
        {
            int free = LookupBits - length;
            int size = symbol & 15;
            for (int rest = 0; rest < 1 << free; rest++)
            {
                int entry = length | symbol << 8;
                if (size <= free)
                {
                    // T.81 table F.1: the upper half of the codes of a size are the positive numbers.
                    int bits = rest >> (free - size);
                    int value = size > 0 && bits < 1 << (size - 1) ? bits - (1 << size) + 1 : bits;
                    entry = (length + size) | HasValue | symbol << 8 | value << 16;
                }

                Lookup[code << free | rest] = entry;
            }
        }
    }
}
