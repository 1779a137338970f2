using System;
using System.IO;
using System.Text;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>
    /// Random access to the elements of a file through a few small pages; only payloads that are asked for are read. An offset or
    /// size that lies outside the file gives false, as does a read that the operating system refuses. Nothing is ever allocated by
    /// a size that the file merely declares.
    /// </summary>
    internal sealed class EbmlReader
    {
        private const int PageSize = 4096;
        private const int MaxPages = 16;
        private const int MaxHeadLength = 12;
        private const int MaxStringLength = 1 << 14;

        private readonly Stream _stream;
        private readonly byte[] _pages;
        private readonly long[] _pageOffsets;
        private readonly int[] _pageLengths;

        public EbmlReader(Stream stream)
        {
            _stream = stream;
            Length = stream.Length;
            int count = (int)Math.Max(1, Math.Min(MaxPages, (Length + PageSize - 1) / PageSize));
            _pages = new byte[count * PageSize];
            _pageOffsets = new long[count];
            _pageLengths = new int[count];
            Array.Fill(_pageOffsets, -1);
        }

        /// <summary>Size of the file in bytes when it was opened.</summary>
        public long Length { get; }

        /// <summary>Fills all of the destination, or gives false.</summary>
        public bool TryRead(long offset, Span<byte> destination)
        {
            if (offset < 0 || destination.Length > Length - offset)
                return false;
            return destination.Length >= PageSize
                ? ReadStream(offset, destination) == destination.Length
                : Peek(offset, destination) == destination.Length;
        }

        /// <summary>Copies as many of the bytes as there are, through the pages; returns their number.</summary>
        public int Peek(long offset, Span<byte> destination)
        {
            int copied = 0;
            while (copied < destination.Length && offset >= 0 && offset < Length)
            {
                ReadOnlySpan<byte> available = PageFrom(offset);
                if (available.IsEmpty)
                    break;
                int length = Math.Min(available.Length, destination.Length - copied);
                available.Slice(0, length).CopyTo(destination.Slice(copied));
                copied += length;
                offset += length;
            }

            return copied;
        }

        /// <summary>The head of the element at an offset. False when there is none, or when its head crosses <paramref name="limit"/>.</summary>
        public bool TryReadElement(long offset, long limit, out EbmlElement element)
        {
            Span<byte> head = stackalloc byte[MaxHeadLength];
            head = head.Slice(0, Peek(offset, head.Slice(0, (int)Math.Max(0, Math.Min(MaxHeadLength, limit - offset)))));
            if (EbmlVarint.TryReadId(head, out uint id, out int idLength)
                && EbmlVarint.TryReadSize(head.Slice(idLength), out long size, out int sizeLength))
            {
                element = new EbmlElement(id, offset, idLength + sizeLength, size);
                return true;
            }

            element = default;
            return false;
        }

        /// <summary>An unsigned integer of 0 to 8 bytes.</summary>
        public bool TryReadUnsigned(in EbmlElement element, out ulong value)
        {
            value = 0;
            if (element.Size < 0 || element.Size > 8)
                return false;
            Span<byte> bytes = stackalloc byte[8];
            bytes = bytes.Slice(0, (int)element.Size);
            if (!TryRead(element.DataOffset, bytes))
                return false;
            foreach (byte b in bytes)
                value = (value << 8) | b;
            return true;
        }

        /// <summary>UTF-8 text up to the first NUL, cut after 16 KiB; empty when it cannot be read.</summary>
        public string ReadString(in EbmlElement element)
        {
            if (element.Size <= 0 || element.Size > Length - element.DataOffset)
                return "";
            Span<byte> bytes = element.Size <= 256 ? stackalloc byte[256] : new byte[Math.Min(element.Size, MaxStringLength)];
            bytes = bytes.Slice(0, (int)Math.Min(element.Size, bytes.Length));
            if (!TryRead(element.DataOffset, bytes))
                return "";
            int end = bytes.IndexOf((byte)0);
            return Encoding.UTF8.GetString(end < 0 ? bytes : bytes.Slice(0, end));
        }

        private ReadOnlySpan<byte> PageFrom(long offset)
        {
            long page = offset / PageSize;
            int slot = (int)(page % _pageOffsets.Length);
            if (_pageOffsets[slot] != page * PageSize)
            {
                _pageLengths[slot] = ReadStream(page * PageSize, _pages.AsSpan(slot * PageSize, PageSize));
                _pageOffsets[slot] = page * PageSize;
            }

            int start = (int)(offset - page * PageSize);
            int length = _pageLengths[slot] - start;
            return length <= 0 ? default : new ReadOnlySpan<byte>(_pages, slot * PageSize + start, length);
        }

        private int ReadStream(long offset, Span<byte> destination)
        {
            int filled = 0;
            try
            {
                _stream.Position = offset;
                while (filled < destination.Length)
                {
                    int read = _stream.Read(destination.Slice(filled));
                    if (read <= 0)
                        break;
                    filled += read;
                }
            }
            catch (IOException)
            {
                // A bad sector or a lost network drive is damage like any other: what was read so far counts.
            }

            return filled;
        }
    }
}
