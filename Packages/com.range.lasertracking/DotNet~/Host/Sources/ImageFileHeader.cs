using System;
using System.Buffers.Binary;
using System.IO;

namespace LaserTracking.Host.Sources
{
    /// <summary>Finds the size of a picture from the first bytes of its file, for the formats that folders of pictures come in.</summary>
    internal static class ImageFileHeader
    {
        /// <summary>False for a damaged, empty or unknown file. Reads a few kilobytes at most, and follows a TIFF's directory.</summary>
        public static bool TryReadSize(string path, out int width, out int height)
        {
            width = height = 0;
            try
            {
                using FileStream file = File.OpenRead(path);
                Span<byte> head = stackalloc byte[4096];
                head = head[..file.ReadAtLeast(head, head.Length, throwOnEndOfStream: false)];
                bool isKnown = TryReadPng(head, out width, out height) || TryReadBitmap(head, out width, out height)
                    || TryReadPortable(head, out width, out height) || TryReadTiff(file, head, out width, out height);
                return isKnown && width > 0 && height > 0;
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                return false;
            }
        }

        /// <summary>It begins like a text, whatever its name says: no byte of its first ones is one that texts do not have.</summary>
        public static bool IsText(string path)
        {
            try
            {
                using FileStream file = File.OpenRead(path);
                Span<byte> head = stackalloc byte[512];
                head = head[..file.ReadAtLeast(head, head.Length, throwOnEndOfStream: false)];
                foreach (byte value in head)
                {
                    if (value < 32 && value is not ((byte)'\t' or (byte)'\n' or (byte)'\r'))
                        return false;
                }

                return head.Length > 0 && !TryReadPortable(head, out _, out _) && head[0] != 0xFF;
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                return false;
            }
        }

        private static bool TryReadPng(ReadOnlySpan<byte> head, out int width, out int height)
        {
            width = height = 0;
            ReadOnlySpan<byte> signature = [0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10];
            if (head.Length < 24 || !head.StartsWith(signature))
                return false;
            width = BinaryPrimitives.ReadInt32BigEndian(head[16..]);
            height = BinaryPrimitives.ReadInt32BigEndian(head[20..]);
            return true;
        }

        private static bool TryReadBitmap(ReadOnlySpan<byte> head, out int width, out int height)
        {
            width = height = 0;
            if (head.Length < 26 || !head.StartsWith("BM"u8))
                return false;
            bool isOld = BinaryPrimitives.ReadInt32LittleEndian(head[14..]) == 12;
            width = isOld ? BinaryPrimitives.ReadUInt16LittleEndian(head[18..]) : BinaryPrimitives.ReadInt32LittleEndian(head[18..]);
            height = isOld ? BinaryPrimitives.ReadUInt16LittleEndian(head[20..]) : BinaryPrimitives.ReadInt32LittleEndian(head[22..]);

            // A negative height says that rows run from the top.
            height = height == int.MinValue ? 0 : Math.Abs(height);
            return true;
        }

        /// <summary>PBM, PGM, PPM: numbers in text with comments between them. PAM: WIDTH and HEIGHT by name.</summary>
        private static bool TryReadPortable(ReadOnlySpan<byte> head, out int width, out int height)
        {
            width = height = 0;
            if (head.Length < 7 || head[0] != 'P' || head[1] < '1' || head[1] > '7')
                return false;
            if (head[1] == '7')
                return TryReadNamed(head, "WIDTH "u8, out width) && TryReadNamed(head, "HEIGHT "u8, out height);
            int at = 2;
            return TryReadNumber(head, ref at, out width) && TryReadNumber(head, ref at, out height);
        }

        private static bool TryReadNamed(ReadOnlySpan<byte> head, ReadOnlySpan<byte> name, out int value)
        {
            value = 0;
            int at = head.IndexOf(name);
            if (at < 0)
                return false;
            at += name.Length;
            return TryReadNumber(head, ref at, out value);
        }

        private static bool TryReadNumber(ReadOnlySpan<byte> head, ref int at, out int value)
        {
            value = 0;
            while (at < head.Length && !char.IsAsciiDigit((char)head[at]))
            {
                if (head[at] == '#')
                {
                    int end = head[at..].IndexOf((byte)'\n');
                    at = end < 0 ? head.Length : at + end;
                }
                else
                {
                    at++;
                }
            }

            int start = at;
            for (; at < head.Length && char.IsAsciiDigit((char)head[at]) && at - start < 9; at++)
                value = value * 10 + head[at] - '0';
            return at > start;
        }

        private static bool TryReadTiff(FileStream file, ReadOnlySpan<byte> head, out int width, out int height)
        {
            width = height = 0;
            if (head.Length < 8 || !(head.StartsWith("II*\0"u8) || head.StartsWith("MM\0*"u8)))
                return false;
            bool isLittle = head[0] == 'I';
            long directory = Read32(head[4..], isLittle);
            Span<byte> entries = stackalloc byte[2 + 12 * 32];
            file.Position = directory;
            entries = entries[..file.ReadAtLeast(entries, entries.Length, throwOnEndOfStream: false)];
            for (int at = 2; at + 12 <= entries.Length && (width == 0 || height == 0); at += 12)
            {
                ReadOnlySpan<byte> entry = entries[at..];
                bool isShort = Read16(entry[2..], isLittle) == 3;
                int value = isShort ? Read16(entry[8..], isLittle) : (int)Math.Min(int.MaxValue, Read32(entry[8..], isLittle));
                if (Read16(entry, isLittle) == 256)
                    width = value;
                else if (Read16(entry, isLittle) == 257)
                    height = value;
            }

            return true;
        }

        private static int Read16(ReadOnlySpan<byte> bytes, bool isLittle) =>
            isLittle ? BinaryPrimitives.ReadUInt16LittleEndian(bytes) : BinaryPrimitives.ReadUInt16BigEndian(bytes);

        private static long Read32(ReadOnlySpan<byte> bytes, bool isLittle) =>
            isLittle ? BinaryPrimitives.ReadUInt32LittleEndian(bytes) : BinaryPrimitives.ReadUInt32BigEndian(bytes);
    }
}
