using System;

namespace LaserTracking.Imaging
{
    /// <summary>Finds where a run of entropy-coded bytes ends and takes the stuffed zeros out of it (T.81 B.1.1.5).</summary>
    internal static class JpegInterval
    {
        /// <summary>
        /// Copies the bytes from <paramref name="offset"/> up to the next marker. Returns the offset after that marker, or the end of
        /// the data when there is none.
        /// </summary>
        /// <param name="jpeg">The whole JPEG.</param>
        /// <param name="offset">First byte of the interval.</param>
        /// <param name="buffer">Receives the bytes, followed by enough zeros for the reader; grows as needed.</param>
        /// <param name="length">Bytes without the stuffing.</param>
        /// <param name="marker">The marker's code, or -1 when the data ends first.</param>
        public static int Extract(ReadOnlySpan<byte> jpeg, int offset, ref byte[] buffer, out int length, out int marker)
        {
            // Only the bytes at hand can follow, so this bounds the buffer by the size of the JPEG.
            int capacity = jpeg.Length - offset + JpegBitReader.Padding;
            if (buffer.Length < capacity)
                buffer = new byte[Math.Max(capacity, buffer.Length * 2)];

            length = 0;
            marker = -1;
            while (offset < jpeg.Length)
            {
                int run = jpeg.Slice(offset).IndexOf((byte)0xFF);
                if (run < 0)
                    run = jpeg.Length - offset;
                jpeg.Slice(offset, run).CopyTo(buffer.AsSpan(length));
                length += run;
                offset += run;
                if (offset + 1 >= jpeg.Length)
                {
                    offset = jpeg.Length;
                    break;
                }

                int code = jpeg[offset + 1];
                if (code == 0)
                {
                    buffer[length++] = 0xFF;
                    offset += 2;
                }
                else if (code == 0xFF)
                {
                    offset++;
                }
                else
                {
                    marker = code;
                    offset += 2;
                    break;
                }
            }

            buffer.AsSpan(length, JpegBitReader.Padding).Clear();
            return offset;
        }

        /// <summary>Where in the JPEG the byte with this position in an extracted interval lies.</summary>
        public static int FileOffset(ReadOnlySpan<byte> jpeg, int offset, int position)
        {
            while (position > 0 && offset + 1 < jpeg.Length)
            {
                int step = jpeg[offset] == 0xFF && jpeg[offset + 1] != 0xFF ? 2 : 1;
                if (jpeg[offset] != 0xFF || step == 2)
                    position--;
                offset += step;
            }

            return offset;
        }
    }
}
