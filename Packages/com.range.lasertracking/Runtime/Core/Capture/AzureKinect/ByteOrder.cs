using System;
using System.Runtime.InteropServices;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Turns most-significant-byte-first 16-bit samples into this machine's order and back.</summary>
    internal static class ByteOrder
    {
        /// <summary>Swaps each pair of bytes in place; an odd last byte stays.</summary>
        public static void Swap16(Span<byte> bytes)
        {
            // Four samples at once in a plain integer: as fast as memory without any vector unit.
            Span<ulong> words = MemoryMarshal.Cast<byte, ulong>(bytes);
            for (int i = 0; i < words.Length; i++)
            {
                ulong word = words[i];
                words[i] = ((word & 0x00FF00FF00FF00FFUL) << 8) | ((word >> 8) & 0x00FF00FF00FF00FFUL);
            }

            for (int i = words.Length * 8; i + 1 < bytes.Length; i += 2)
                (bytes[i], bytes[i + 1]) = (bytes[i + 1], bytes[i]);
        }
    }
}
