using System;
#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
#endif

namespace LaserTracking.Imaging
{
    /// <summary>
    /// Raw pictures to B G R A for display and reports: BT.601 with full range (JFIF 1.02), 16-bit fixed point, chroma repeated over
    /// the pixels that share it. The scalar and the vector version agree to the bit.
    /// </summary>
    public static unsafe class ColorConversion
    {
        // Times 2^16.
        private const int RedFromV = 91881;
        private const int GreenFromU = -22554;
        private const int GreenFromV = -46802;
        private const int BlueFromU = 116130;
        private const int Half = 1 << 15;

        /// <summary>Any colour or grey picture to Bgra32 of the same size and time.</summary>
        /// <exception cref="ArgumentException">No picture, depth or infrared, or both arguments are the same picture.</exception>
        public static void ToBgra(Image source, Image target)
        {
            if (source.Format == PixelFormat.None || source.Format > PixelFormat.Gray8 || ReferenceEquals(source, target))
                throw new ArgumentException($"a picture of format {source.Format} has no colours to convert", nameof(source));
            target.Reset(PixelFormat.Bgra32, source.Width, source.Height, source.TimeUs);
            for (int y = 0; y < source.Height; y++)
            {
                byte* row = source.Pixels + (long)y * source.Stride;
                byte* bgra = target.Pixels + (long)y * target.Stride;
                switch (source.Format)
                {
                    case PixelFormat.Yuy2:
                        Yuy2ToBgra(row, bgra, source.Width);
                        break;
                    case PixelFormat.Nv12:
                        Nv12ToBgra(row, source.Pixels + (long)(source.Height + y / 2) * source.Stride, bgra, source.Width);
                        break;
                    case PixelFormat.Gray8:
                        Gray8ToBgra(row, bgra, source.Width);
                        break;
                    default:
                        Buffer.MemoryCopy(row, bgra, target.Stride, 4L * source.Width);
                        break;
                }
            }
        }

        /// <summary>One row of Y0 U Y1 V; <paramref name="width"/> is even.</summary>
        public static void Yuy2ToBgra(byte* yuy2, byte* bgra, int width)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (Vector128.IsHardwareAccelerated)
            {
                for (; x + 8 <= width; x += 8)
                {
                    Vector128<ushort> packed = Vector128.Load((ushort*)(yuy2 + 2 * x));
                    EightToBgra(packed & Vector128.Create((ushort)0xFF), Vector128.ShiftRightLogical(packed, 8), bgra + 4 * x);
                }
            }
#endif
            Yuy2ToBgraScalar(yuy2 + 2 * x, bgra + 4 * x, width - x);
        }

        public static void Yuy2ToBgraScalar(byte* yuy2, byte* bgra, int width)
        {
            for (int x = 0; x < width; x += 2, yuy2 += 4, bgra += 8)
            {
                YuvToBgra(yuy2[0], yuy2[1], yuy2[3], bgra);
                YuvToBgra(yuy2[2], yuy2[1], yuy2[3], bgra + 4);
            }
        }

        /// <summary>One row of luma and the row of interleaved U V that goes with it; <paramref name="width"/> is even.</summary>
        public static void Nv12ToBgra(byte* luma, byte* chroma, byte* bgra, int width)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (Vector128.IsHardwareAccelerated)
            {
                for (; x + 8 <= width; x += 8)
                    EightToBgra(WidenEight(luma + x), WidenEight(chroma + x), bgra + 4 * x);
            }
#endif
            Nv12ToBgraScalar(luma + x, chroma + x, bgra + 4 * x, width - x);
        }

        public static void Nv12ToBgraScalar(byte* luma, byte* chroma, byte* bgra, int width)
        {
            for (int x = 0; x < width; x += 2, bgra += 8)
            {
                YuvToBgra(luma[x], chroma[x], chroma[x + 1], bgra);
                YuvToBgra(luma[x + 1], chroma[x], chroma[x + 1], bgra + 4);
            }
        }

        /// <summary>One row of B G R, as OpenCV hands pictures out.</summary>
        public static void BgrToBgra(byte* bgr, byte* bgra, int width)
        {
            for (int x = 0; x < width; x++, bgr += 3, bgra += 4)
            {
                bgra[0] = bgr[0];
                bgra[1] = bgr[1];
                bgra[2] = bgr[2];
                bgra[3] = 255;
            }
        }

        public static void Gray8ToBgra(byte* gray, byte* bgra, int width)
        {
            uint* pixels = (uint*)bgra;
            for (int x = 0; x < width; x++)
                pixels[x] = gray[x] * 0x010101u | 0xFF000000u;
        }

        internal static void YuvToBgra(int luma, int u, int v, byte* bgra)
        {
            u -= 128;
            v -= 128;
            bgra[0] = Clamp(luma + ((BlueFromU * u + Half) >> 16));
            bgra[1] = Clamp(luma + ((GreenFromU * u + GreenFromV * v + Half) >> 16));
            bgra[2] = Clamp(luma + ((RedFromV * v + Half) >> 16));
            bgra[3] = 255;
        }

        private static byte Clamp(int value) => (byte)(value < 0 ? 0 : value > 255 ? 255 : value);

#if NET8_0_OR_GREATER
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<ushort> WidenEight(byte* bytes) =>
            Vector128.WidenLower(Vector128.CreateScalarUnsafe(*(ulong*)bytes).AsByte());

        /// <summary>Eight lumas and four pairs U V.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void EightToBgra(Vector128<ushort> luma, Vector128<ushort> chroma, byte* bgra)
        {
            Vector128<int> offset = Vector128.Create(128);
            Vector128<int> half = Vector128.Create(Half);
            Vector128<int> u = (chroma.AsInt32() & Vector128.Create(0xFF)) - offset;
            Vector128<int> v = Vector128.ShiftRightLogical(chroma.AsInt32(), 16) - offset;
            Vector128<ushort> blue = Add(luma, Vector128.ShiftRightArithmetic(u * Vector128.Create(BlueFromU) + half, 16));
            Vector128<ushort> green = Add(
                luma,
                Vector128.ShiftRightArithmetic(u * Vector128.Create(GreenFromU) + v * Vector128.Create(GreenFromV) + half, 16));
            Vector128<ushort> red = Add(luma, Vector128.ShiftRightArithmetic(v * Vector128.Create(RedFromV) + half, 16));

            Vector128<ushort> blueGreen = blue | Vector128.ShiftLeft(green, 8);
            Vector128<ushort> redAlpha = red | Vector128.Create((ushort)0xFF00);
            uint* pixels = (uint*)bgra;
            (Vector128.WidenLower(blueGreen) | Vector128.ShiftLeft(Vector128.WidenLower(redAlpha), 16)).Store(pixels);
            (Vector128.WidenUpper(blueGreen) | Vector128.ShiftLeft(Vector128.WidenUpper(redAlpha), 16)).Store(pixels + 4);
        }

        /// <summary>Adds each of four differences to two neighbouring lumas and clamps to a byte.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<ushort> Add(Vector128<ushort> luma, Vector128<int> difference)
        {
            Vector128<int> twice = (difference & Vector128.Create(0xFFFF)) | Vector128.ShiftLeft(difference, 16);
            Vector128<short> sum = luma.AsInt16() + twice.AsInt16();
            return Vector128.Min(Vector128.Max(sum, Vector128<short>.Zero), Vector128.Create((short)255)).AsUInt16();
        }
#endif
    }
}
