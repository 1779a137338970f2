using System.Buffers.Binary;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// Decodes blocks of coefficients from one restart interval, whose stuffed zero bytes are already taken out. Past the end it
    /// reads zeros; the caller asks <see cref="IsOverrun"/> after every unit, and keeps <see cref="Padding"/> readable bytes behind.
    /// </summary>
    [StructLayout(LayoutKind.Auto)]
    internal unsafe struct JpegBitReader
    {
        /// <summary>Zero bytes that must follow the interval: what a unit of ten blocks can use up at most, and one refill.</summary>
        public const int Padding = 10 * 64 * 4 + 16;

        private readonly byte* _end;
        private byte* _next;
        private ulong _bits;
        private int _count;

        public JpegBitReader(byte* start, int length)
        {
            _next = start;
            _end = start + length;
            _bits = 0;
            _count = 0;
        }

        /// <summary>True when more bits were used than there are.</summary>
        public readonly bool IsOverrun => _next - (_count >> 3) > _end;

        /// <summary>First byte of which no bit was used.</summary>
        public readonly byte* Position => _next - (_count >> 3);

        /// <summary>
        /// Decodes one block: dequantised coefficients, row by row, into <paramref name="block"/>, which must be zero before.
        /// Returns the zigzag index of the last coefficient (0 = only DC), or -1 for a code that does not exist.
        /// </summary>
        /// <param name="dc">Huffman code of the DC differences.</param>
        /// <param name="ac">Huffman code of the other coefficients.</param>
        /// <param name="quantisation">64 factors in zigzag order.</param>
        /// <param name="prediction">The component's last DC value; updated.</param>
        /// <param name="block">64 coefficients.</param>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public int DecodeBlock(JpegHuffmanTable dc, JpegHuffmanTable ac, ushort* quantisation, ref int prediction, short* block)
        {
            byte* next = _next;
            ulong bits = _bits;
            int count = _count;
            int last = 0;
            fixed (int* dcLookup = dc.Lookup, acLookup = ac.Lookup)
            fixed (byte* zigzag = JpegTables.ZigZag)
            {
                Refill(ref next, ref bits, ref count);
                int entry = dcLookup[bits >> (64 - JpegHuffmanTable.LookupBits)];
                int difference = entry >> 16;
                if ((entry & JpegHuffmanTable.HasValue) == 0)
                {
                    if (!ReadLong(dc, entry, ref bits, ref count, out _, out difference))
                        return -1;
                }
                else
                {
                    int used = entry & 0x7F;
                    bits <<= used;
                    count -= used;
                }

                prediction += difference;
                block[0] = (short)(prediction * quantisation[0]);

                for (int k = 1; k < 64; k++)
                {
                    if (count < 32)
                        Refill(ref next, ref bits, ref count);
                    entry = acLookup[bits >> (64 - JpegHuffmanTable.LookupBits)];
                    int value = entry >> 16;
                    int symbol = entry >> 8 & 0xFF;
                    if ((entry & JpegHuffmanTable.HasValue) == 0)
                    {
                        if (!ReadLong(ac, entry, ref bits, ref count, out symbol, out value))
                            return -1;
                    }
                    else
                    {
                        int used = entry & 0x7F;
                        bits <<= used;
                        count -= used;
                    }

                    if ((symbol & 15) == 0)
                    {
                        if (symbol != 0xF0)
                        {
                            if (symbol != 0)
                                return -1;
                            break;
                        }

                        k += 15;
                        continue;
                    }

                    k += symbol >> 4;
                    if (k > 63)
                        return -1;
                    block[zigzag[k]] = (short)(value * quantisation[k]);
                    last = k;
                }
            }

            _next = next;
            _bits = bits;
            _count = count;
            return last;
        }

        /// <summary>A code that is longer than the look-up, or one whose coefficient is.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        private static bool ReadLong(JpegHuffmanTable table, int entry, ref ulong bits, ref int count, out int symbol, out int value)
        {
            symbol = value = 0;
            if (entry == 0)
                entry = table.FindLong((int)(bits >> 48));
            if (entry < 0)
                return false;
            int length = entry & 0x7F;
            bits <<= length;
            count -= length;
            symbol = entry >> 8 & 0xFF;
            int size = symbol & 15;
            if (size > 0)
            {
                int raw = (int)(bits >> (64 - size));
                value = raw < 1 << (size - 1) ? raw - (1 << size) + 1 : raw;
                bits <<= size;
                count -= size;
            }

            return true;
        }

        /// <summary>Leaves at least 56 bits. What lies below the counted bits is equal to the bytes that come next, so or-ing is safe.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Refill(ref byte* next, ref ulong bits, ref int count)
        {
            bits |= BinaryPrimitives.ReverseEndianness(*(ulong*)next) >> count;
            next += (63 - count) >> 3;
            count |= 56;
        }
    }
}
