using System;
using System.Buffers.Binary;
using System.IO;
using System.IO.Compression;
using System.Text;
using LaserTracking.Capture.Matroska;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Pictures
{
    /// <summary>Writes pictures as PNG, 8-bit RGB (ISO/IEC 15948). For reports and explanations, not for the frame loop.</summary>
    internal static class PngEncoder
    {
        private const byte TrueColor = 2;

        private static ReadOnlySpan<byte> Signature => new byte[] { 0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A };

        /// <summary>Encodes a Bgra32 picture; alpha is left out.</summary>
        public static byte[] Encode(Image bgra)
        {
            if (bgra.Format != PixelFormat.Bgra32)
                throw new ArgumentException("only Bgra32 pictures can be encoded");
            var file = new MemoryStream();
            file.Write(Signature);
            var header = new byte[13];
            BinaryPrimitives.WriteInt32BigEndian(header, bgra.Width);
            BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), bgra.Height);
            header[8] = 8;
            header[9] = TrueColor;
            WriteChunk(file, "IHDR", header);
            WriteChunk(file, "IDAT", Compress(bgra));
            WriteChunk(file, "IEND", default);
            return file.ToArray();
        }

        /// <summary>Rows with the "up" filter: the difference from the row above packs well in drawn pictures.</summary>
        private static byte[] Compress(Image bgra)
        {
            int width = bgra.Width, stride = bgra.Stride;
            var row = new byte[1 + 3 * width];
            var packed = new MemoryStream();
            using (var zlib = new ZLibStream(packed, CompressionLevel.SmallestSize, leaveOpen: true))
            {
                ReadOnlySpan<byte> pixels = bgra.Bytes;
                for (int y = 0; y < bgra.Height; y++)
                {
                    row[0] = 2;
                    ReadOnlySpan<byte> now = pixels.Slice(y * stride, 4 * width), above = y > 0 ? pixels.Slice((y - 1) * stride, 4 * width) : default;
                    for (int x = 0; x < width; x++)
                    {
                        for (int c = 0; c < 3; c++)
                            row[1 + 3 * x + c] = (byte)(now[4 * x + 2 - c] - (above.IsEmpty ? 0 : above[4 * x + 2 - c]));
                    }

                    zlib.Write(row);
                }
            }

            return packed.ToArray();
        }

        private static void WriteChunk(Stream file, string type, ReadOnlySpan<byte> data)
        {
            Span<byte> number = stackalloc byte[4];
            BinaryPrimitives.WriteInt32BigEndian(number, data.Length);
            file.Write(number);
            byte[] name = Encoding.ASCII.GetBytes(type);
            file.Write(name);
            file.Write(data);
            BinaryPrimitives.WriteUInt32BigEndian(number, Crc32.Append(Crc32.Append(0, name), data));
            file.Write(number);
        }
    }
}
