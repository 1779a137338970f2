using System.Buffers.Binary;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>Grey pictures in the formats of cameras.</summary>
    internal static class TestPlanes
    {
        /// <summary>The same brightness in another format, rows padded with white.</summary>
        public static void Fill(Image picture, Image gray, PixelFormat format, int paddingBytes)
        {
            picture.Reset(format, gray.Width, gray.Height, gray.TimeUs, Image.TightStride(format, gray.Width) + paddingBytes);
            picture.Bytes.Fill(format == PixelFormat.Nv12 || format == PixelFormat.Yuy2 ? (byte)128 : (byte)255);
            for (int y = 0; y < gray.Height; y++)
            for (int x = 0; x < gray.Width; x++)
            {
                byte level = gray.Bytes[y * gray.Stride + x];
                int row = y * picture.Stride;
                switch (format)
                {
                    case PixelFormat.Bgra32:
                        picture.Bytes.Slice(row + 4 * x, 3).Fill(level);
                        break;
                    case PixelFormat.Yuy2:
                        picture.Bytes[row + 2 * x] = level;
                        break;
                    case PixelFormat.Infrared16:
                        BinaryPrimitives.WriteUInt16LittleEndian(picture.Bytes.Slice(row + 2 * x), (ushort)(level * 37));
                        break;
                    default:
                        picture.Bytes[row + x] = level;
                        break;
                }
            }
        }
    }
}
