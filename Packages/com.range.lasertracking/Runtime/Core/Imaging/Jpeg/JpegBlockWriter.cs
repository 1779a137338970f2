#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
#endif

namespace LaserTracking.Imaging
{
    /// <summary>
    /// Puts the decoded blocks of one unit (64 bytes each, row by row, in the order of the stream) where they belong in the picture.
    /// Units are written whole: one that reaches over the picture's edge goes to a scratch picture first.
    /// </summary>
    internal static unsafe class JpegBlockWriter
    {
        /// <summary>Blocks Y Y U V of 16×8 pixels to rows of Y0 U Y1 V.</summary>
        public static void WriteYuy2(byte* blocks, byte* target, int stride)
        {
#if NET8_0_OR_GREATER
            if (Vector128.IsHardwareAccelerated)
            {
                for (int y = 0; y < 8; y++, blocks += 8, target += stride)
                {
                    Vector128<byte> chroma = Interleave(blocks + 128, blocks + 192);
                    Vector128<byte> luma = Vector128.Create(*(ulong*)blocks, *(ulong*)(blocks + 64)).AsByte();
                    (Vector128.WidenLower(luma) | Vector128.ShiftLeft(Vector128.WidenLower(chroma), 8)).Store((ushort*)target);
                    (Vector128.WidenUpper(luma) | Vector128.ShiftLeft(Vector128.WidenUpper(chroma), 8)).Store((ushort*)target + 8);
                }

                return;
            }
#endif
            WriteYuy2Scalar(blocks, target, stride);
        }

        public static void WriteYuy2Scalar(byte* blocks, byte* target, int stride)
        {
            for (int y = 0; y < 8; y++, blocks += 8, target += stride)
            {
                for (int x = 0; x < 4; x++)
                {
                    byte* left = target + x * 4;
                    left[0] = blocks[2 * x];
                    left[1] = blocks[128 + x];
                    left[2] = blocks[2 * x + 1];
                    left[3] = blocks[192 + x];
                    byte* right = left + 16;
                    right[0] = blocks[64 + 2 * x];
                    right[1] = blocks[128 + 4 + x];
                    right[2] = blocks[64 + 2 * x + 1];
                    right[3] = blocks[192 + 4 + x];
                }
            }
        }

        /// <summary>Blocks Y Y Y Y U V of 16×16 pixels to 16 rows of luma and 8 rows of interleaved U V.</summary>
        public static void WriteNv12(byte* blocks, byte* luma, byte* chroma, int stride)
        {
            for (int y = 0; y < 16; y++, luma += stride)
            {
                byte* left = blocks + (y & 8) * 16 + (y & 7) * 8;
                ((ulong*)luma)[0] = *(ulong*)left;
                ((ulong*)luma)[1] = *(ulong*)(left + 64);
            }

            byte* u = blocks + 256;
            for (int y = 0; y < 8; y++, u += 8, chroma += stride)
            {
#if NET8_0_OR_GREATER
                if (Vector128.IsHardwareAccelerated)
                {
                    Interleave(u, u + 64).Store(chroma);
                    continue;
                }
#endif
                for (int x = 0; x < 8; x++)
                {
                    chroma[2 * x] = u[x];
                    chroma[2 * x + 1] = u[64 + x];
                }
            }
        }

        public static void WriteGray(byte* blocks, byte* target, int stride)
        {
            for (int y = 0; y < 8; y++, target += stride)
                *(ulong*)target = ((ulong*)blocks)[y];
        }

        /// <summary>
        /// Any sampling to B G R A; coarser components are repeated. Conversion as JFIF 1.02 gives it, in 16-bit fixed point as the
        /// Independent JPEG Group's library does.
        /// </summary>
        /// <param name="frame">Sampling factors and where the components' blocks begin.</param>
        /// <param name="blocks">The unit's blocks.</param>
        /// <param name="target">Top left pixel of the unit.</param>
        /// <param name="stride">Bytes from row to row.</param>
        /// <param name="width">Pixels of the unit inside the picture, 1…32.</param>
        /// <param name="height">Rows of the unit inside the picture.</param>
        public static void WriteBgra(JpegFrameHeader frame, byte* blocks, byte* target, int stride, int width, int height)
        {
            for (int y = 0; y < height; y++, target += stride)
            {
                for (int x = 0; x < width; x++)
                {
                    int c0 = Sample(frame, 0, blocks, x, y);
                    int c1 = Sample(frame, 1, blocks, x, y);
                    int c2 = Sample(frame, 2, blocks, x, y);
                    byte* pixel = target + x * 4;
                    if (frame.IsRgb)
                    {
                        pixel[0] = (byte)c2;
                        pixel[1] = (byte)c1;
                        pixel[2] = (byte)c0;
                        pixel[3] = 255;
                    }
                    else
                    {
                        ColorConversion.YuvToBgra(c0, c1, c2, pixel);
                    }
                }
            }
        }

        private static int Sample(JpegFrameHeader frame, int index, byte* blocks, int x, int y)
        {
            ref readonly JpegComponent component = ref frame.Components[index];
            x = x * component.Horizontal / frame.MaxHorizontal;
            y = y * component.Vertical / frame.MaxVertical;
            int block = component.FirstBlock + (y >> 3) * component.Horizontal + (x >> 3);
            return blocks[block * 64 + (y & 7) * 8 + (x & 7)];
        }

#if NET8_0_OR_GREATER
        /// <summary>Eight bytes of each, alternating.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<byte> Interleave(byte* even, byte* odd)
        {
            Vector128<ushort> low = Vector128.WidenLower(Vector128.CreateScalarUnsafe(*(ulong*)even).AsByte());
            Vector128<ushort> high = Vector128.WidenLower(Vector128.CreateScalarUnsafe(*(ulong*)odd).AsByte());
            return (low | Vector128.ShiftLeft(high, 8)).AsByte();
        }
#endif
    }
}
