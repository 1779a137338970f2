using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>A file in memory whose pages exist only where something was written: files of gigabytes for tests.</summary>
    internal sealed class HoleStream : Stream
    {
        private const int PageSize = 1 << 16;

        private readonly Dictionary<long, byte[]> _pages = new Dictionary<long, byte[]>();
        private long _length;

        public override bool CanRead => true;

        public override bool CanSeek => true;

        public override bool CanWrite => true;

        public override long Length => _length;

        public override long Position { get; set; }

        /// <summary>An EBML Void of this many bytes of data, of which none is stored.</summary>
        public void WriteVoid(long bytes)
        {
            var head = new byte[9];
            head[0] = (byte)MatroskaIds.Void;
            EbmlVarint.WriteSize(head.AsSpan(1), bytes);
            Write(head, 0, head.Length);
            Position += bytes;
            _length = Math.Max(_length, Position);
        }

        public override void Write(byte[] buffer, int offset, int count)
        {
            for (int i = 0; i < count; i++, Position++)
            {
                if (!_pages.TryGetValue(Position / PageSize, out byte[]? page))
                    _pages.Add(Position / PageSize, page = new byte[PageSize]);
                page[Position % PageSize] = buffer[offset + i];
            }

            _length = Math.Max(_length, Position);
        }

        public override int Read(byte[] buffer, int offset, int count)
        {
            count = (int)Math.Min(count, _length - Position);
            for (int i = 0; i < count; i++, Position++)
                buffer[offset + i] = _pages.TryGetValue(Position / PageSize, out byte[]? page) ? page[Position % PageSize] : (byte)0;
            return count;
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Flush()
        {
        }
    }
}
