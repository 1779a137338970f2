using System.Runtime.CompilerServices;
#if NET8_0_OR_GREATER
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
        /// <summary>Two blocks of luma side by side and one of each chroma, 16×8 pixels, to rows of Y0 U Y1 V.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void WriteYuy2(byte* luma, byte* u, byte* v, byte* target, int stride)
        {
#if NET8_0_OR_GREATER
            if (Vector128.IsHardwareAccelerated)
            {
                for (int y = 0; y < 8; y++, luma += 8, u += 8, v += 8, target += stride)
                {
                    Vector128<byte> uv = Interleave(u, v);
                    Vector128<byte> row = Vector128.Create(*(ulong*)luma, *(ulong*)(luma + 64)).AsByte();
                    (Vector128.WidenLower(row) | Vector128.ShiftLeft(Vector128.WidenLower(uv), 8)).Store((ushort*)target);
                    (Vector128.WidenUpper(row) | Vector128.ShiftLeft(Vector128.WidenUpper(uv), 8)).Store((ushort*)target + 8);
                }

                return;
            }
#endif
            WriteYuy2Scalar(luma, u, v, target, stride);
        }

        public static void WriteYuy2Scalar(byte* luma, byte* u, byte* v, byte* target, int stride)
        {
            for (int y = 0; y < 8; y++, luma += 8, u += 8, v += 8, target += stride)
            {
                for (int x = 0; x < 8; x++)
                {
                    byte* pair = luma + (x & 4) * 16 + 2 * (x & 3);
                    target[4 * x] = pair[0];
                    target[4 * x + 1] = u[x];
                    target[4 * x + 2] = pair[1];
                    target[4 * x + 3] = v[x];
                }
            }
        }

        /// <summary>Blocks Y Y Y Y U V of 16×16 pixels to 16 rows of luma and 8 rows of interleaved U V.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
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

        [MethodImpl(JitOptions.OptimizeAtOnce)]
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
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void WriteBgra(JpegFrameHeader frame, byte* blocks, byte* target, int stride, int width, int height)
        {
            int* columns = stackalloc int[3 * 32];
            byte** rows = stackalloc byte*[3];
            for (int i = 0; i < 3; i++)
            {
                for (int x = 0; x < width; x++)
                {
                    int column = x * frame.Components[i].Horizontal / frame.MaxHorizontal;
                    columns[i * 32 + x] = (column >> 3) * 64 + (column & 7);
                }
            }

            for (int y = 0; y < height; y++, target += stride)
            {
                for (int i = 0; i < 3; i++)
                {
                    ref readonly JpegComponent component = ref frame.Components[i];
                    int row = y * component.Vertical / frame.MaxVertical;
                    rows[i] = blocks + 64 * (component.FirstBlock + (row >> 3) * component.Horizontal) + (row & 7) * 8;
                }

                for (int x = 0; x < width; x++)
                {
                    byte c0 = rows[0][columns[x]];
                    byte c1 = rows[1][columns[32 + x]];
                    byte c2 = rows[2][columns[64 + x]];
                    byte* pixel = target + x * 4;
                    if (frame.IsRgb)
                    {
                        pixel[0] = c2;
                        pixel[1] = c1;
                        pixel[2] = c0;
                        pixel[3] = 255;
                    }
                    else
                    {
                        ColorConversion.YuvToBgra(c0, c1, c2, pixel);
                    }
                }
            }
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
