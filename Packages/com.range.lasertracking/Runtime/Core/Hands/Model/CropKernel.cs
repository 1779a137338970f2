using System;
using System.Runtime.CompilerServices;
using LaserTracking.Imaging;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Cuts a <see cref="HandRegion"/> out of a picture: bilinear, one sample a crop pixel, edge pixels repeated outside of the
    /// picture, red green blue 0…1. Infrared is linear and without a unit: its mean is brought to a quarter and the root drawn, which
    /// is about how a camera shows such a hand in grey.
    /// </summary>
    internal static unsafe class CropKernel
    {
        private const float InfraredMean = 0.25f;

        /// <param name="picture">Any format but depth.</param>
        /// <param name="region">Valid.</param>
        /// <param name="size">Side of the crop in its own pixels.</param>
        /// <param name="rgb">size × size × 3.</param>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void Cut(Image picture, HandRegion region, int size, float* rgb)
        {
            float sum = 0;
            int lastX = picture.Width - 1, lastY = picture.Height - 1;
            PixelFormat format = picture.Format;
            byte* pixels = picture.Pixels;
            long stride = picture.Stride;
            double cos = Math.Cos(region.RotationRad), sin = Math.Sin(region.RotationRad), step = region.SidePx / size;
            for (int j = 0; j < size; j++)
            {
                double v = (j + 0.5) * step - 0.5 * region.SidePx;
                double rowX = region.CenterXPx - v * sin - 0.5, rowY = region.CenterYPx + v * cos - 0.5;
                for (int i = 0; i < size; i++, rgb += 3)
                {
                    double u = (i + 0.5) * step - 0.5 * region.SidePx;
                    double x = Limit(rowX + u * cos, lastX), y = Limit(rowY + u * sin, lastY);
                    int left = (int)x, top = (int)y;
                    int right = left < lastX ? left + 1 : left, bottom = top < lastY ? top + 1 : top;
                    float toRight = (float)(x - left), toBottom = (float)(y - top);
                    switch (format)
                    {
                        case PixelFormat.Bgra32:
                            MixBgra(pixels + top * stride, pixels + bottom * stride, left, right, toRight, toBottom, rgb);
                            break;
                        case PixelFormat.Infrared16:
                            var above = (ushort*)(pixels + top * stride);
                            var below = (ushort*)(pixels + bottom * stride);
                            sum += rgb[0] = Mix(above[left], above[right], below[left], below[right], toRight, toBottom);
                            break;
                        default:
                            MixOther(picture, left, right, top, bottom, toRight, toBottom, rgb);
                            break;
                    }
                }
            }

            if (picture.Format == PixelFormat.Infrared16)
                Expose(rgb - 3L * size * size, size * size, sum);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void MixBgra(byte* above, byte* below, int left, int right, float toRight, float toBottom, float* rgb)
        {
            byte* a = above + 4 * left;
            byte* b = above + 4 * right;
            byte* c = below + 4 * left;
            byte* d = below + 4 * right;
            rgb[0] = Mix(a[2], b[2], c[2], d[2], toRight, toBottom) * (1f / 255);
            rgb[1] = Mix(a[1], b[1], c[1], d[1], toRight, toBottom) * (1f / 255);
            rgb[2] = Mix(a[0], b[0], c[0], d[0], toRight, toBottom) * (1f / 255);
        }

        /// <summary>Grey and the formats of cameras, pixel by pixel: the crop is far smaller than the picture.</summary>
        private static void MixOther(Image picture, int left, int right, int top, int bottom, float toRight, float toBottom, float* rgb)
        {
            byte* four = stackalloc byte[16];
            Fetch(picture, left, top, four);
            Fetch(picture, right, top, four + 4);
            Fetch(picture, left, bottom, four + 8);
            Fetch(picture, right, bottom, four + 12);
            MixBgra(four, four + 8, 0, 1, toRight, toBottom, rgb);
        }

        private static void Fetch(Image picture, int x, int y, byte* bgra)
        {
            byte* row = picture.Pixels + (long)y * picture.Stride;
            switch (picture.Format)
            {
                case PixelFormat.Nv12:
                    byte* chroma = picture.Pixels + (long)(picture.Height + y / 2) * picture.Stride + (x & ~1);
                    ColorConversion.YuvToBgra(row[x], chroma[0], chroma[1], bgra);
                    break;
                case PixelFormat.Yuy2:
                    byte* pair = row + 4 * (x / 2);
                    ColorConversion.YuvToBgra(row[2 * x], pair[1], pair[3], bgra);
                    break;
                default:
                    bgra[0] = bgra[1] = bgra[2] = row[x];
                    break;
            }
        }

        private static double Limit(double value, double last) => value < 0 ? 0 : value > last ? last : value;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float Mix(float a, float b, float c, float d, float toRight, float toBottom)
        {
            float top = a + (b - a) * toRight, bottom = c + (d - c) * toRight;
            return top + (bottom - top) * toBottom;
        }

        private static void Expose(float* rgb, int pixels, float sum)
        {
            float gain = sum > 0 ? InfraredMean * pixels / sum : 0;
            for (int i = 0; i < pixels; i++, rgb += 3)
                rgb[0] = rgb[1] = rgb[2] = (float)Math.Sqrt(Math.Min(1, gain * rgb[0]));
        }
    }
}
