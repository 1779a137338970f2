using System;
using System.Buffers.Binary;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>CRC-32 of IEEE 802.3 (reflected 0xEDB88320), as Matroska's CRC-32 elements hold it. Eight table look-ups for 8 bytes.</summary>
    public static class Crc32
    {
        private static readonly uint[] Table = CreateTable();

        /// <summary>Continues a checksum; start with 0.</summary>
        public static uint Append(uint crc, ReadOnlySpan<byte> bytes)
        {
            uint[] table = Table;
            crc = ~crc;
            while (bytes.Length >= 8)
            {
                uint low = BinaryPrimitives.ReadUInt32LittleEndian(bytes) ^ crc;
                uint high = BinaryPrimitives.ReadUInt32LittleEndian(bytes.Slice(4));
                crc = table[7 * 256 + (int)(low & 0xFF)] ^ table[6 * 256 + (int)((low >> 8) & 0xFF)]
                    ^ table[5 * 256 + (int)((low >> 16) & 0xFF)] ^ table[4 * 256 + (int)(low >> 24)]
                    ^ table[3 * 256 + (int)(high & 0xFF)] ^ table[2 * 256 + (int)((high >> 8) & 0xFF)]
                    ^ table[256 + (int)((high >> 16) & 0xFF)] ^ table[(int)(high >> 24)];
                bytes = bytes.Slice(8);
            }

            foreach (byte b in bytes)
                crc = (crc >> 8) ^ table[(int)((crc ^ b) & 0xFF)];
            return ~crc;
        }

        private static uint[] CreateTable()
        {
            var table = new uint[8 * 256];
            for (uint i = 0; i < 256; i++)
            {
                uint value = i;
                for (int bit = 0; bit < 8; bit++)
                    value = (value & 1) != 0 ? (value >> 1) ^ 0xEDB88320u : value >> 1;
                table[i] = value;
            }

            for (int i = 256; i < table.Length; i++)
                table[i] = (table[i - 256] >> 8) ^ table[(int)(table[i - 256] & 0xFF)];
            return table;
        }
    }
}
