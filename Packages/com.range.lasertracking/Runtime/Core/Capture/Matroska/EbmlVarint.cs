using System;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>Variable-length integers of EBML (RFC 8794, section 4): the leading zero bits of the first byte tell the length.</summary>
    public static class EbmlVarint
    {
        /// <summary>What <see cref="TryReadSize"/> gives for the reserved value "size unknown" (all value bits set).</summary>
        public const long UnknownSize = -1;

        /// <summary>Length in bytes that the first byte announces, 1 to 8; 9 for a zero byte, which is invalid.</summary>
        public static int LengthOf(byte first)
        {
            int length = 1;
            for (int mask = 0x80; mask != 0 && (first & mask) == 0; mask >>= 1)
                length++;
            return length;
        }

        /// <summary>An element id with its marker bits, of 1 to 4 bytes. False when there is none or the bytes end inside it.</summary>
        public static bool TryReadId(ReadOnlySpan<byte> bytes, out uint id, out int length)
        {
            id = 0;
            length = bytes.IsEmpty ? 9 : LengthOf(bytes[0]);
            if (length > 4 || length > bytes.Length)
                return false;
            for (int i = 0; i < length; i++)
                id = (id << 8) | bytes[i];
            return true;
        }

        /// <summary>An unsigned value of 1 to 8 bytes (0 to 2^56 - 2), or <see cref="UnknownSize"/>. False when the bytes end inside it.</summary>
        public static bool TryReadSize(ReadOnlySpan<byte> bytes, out long value, out int length)
        {
            value = 0;
            length = bytes.IsEmpty ? 9 : LengthOf(bytes[0]);
            if (length > 8 || length > bytes.Length)
                return false;
            value = bytes[0] & (0xFF >> length);
            for (int i = 1; i < length; i++)
                value = (value << 8) | bytes[i];
            if (value == (1L << (7 * length)) - 1)
                value = UnknownSize;
            return true;
        }

        /// <summary>A signed difference as EBML lacing stores it: the value less half of its range.</summary>
        public static bool TryReadSigned(ReadOnlySpan<byte> bytes, out long value, out int length)
        {
            if (!TryReadSize(bytes, out value, out length))
                return false;
            if (value == UnknownSize)
                value = (1L << (7 * length)) - 1;
            value -= (1L << (7 * length - 1)) - 1;
            return true;
        }

        /// <summary>Fewest bytes that hold a size, 1 to 8.</summary>
        public static int SizeLengthOf(long size)
        {
            int length = 1;
            // All bits set means "unknown" at every length.
            while (length < 8 && size >= (1L << (7 * length)) - 1)
                length++;
            return length;
        }

        /// <summary>Writes a size, or <see cref="UnknownSize"/>, over the whole destination of 1 to 8 bytes.</summary>
        public static void WriteSize(Span<byte> destination, long size)
        {
            int length = destination.Length;
            long value = size == UnknownSize ? (1L << (7 * length)) - 1 : size;
            for (int i = length - 1; i >= 0; i--, value >>= 8)
                destination[i] = (byte)value;
            destination[0] |= (byte)(0x80 >> (length - 1));
        }
    }
}
