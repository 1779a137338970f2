using System;
using System.Runtime.CompilerServices;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Cuts a <see cref="HandRegion"/> out of a picture: bilinear, one sample a crop pixel, edge pixels repeated outside of the
    /// picture, red green blue 0…1; a band is a row of the crop. Infrared is linear and without a unit: here it is only its red, and
    /// <see cref="ExposureBands"/> does the rest.
    /// </summary>
    internal unsafe struct CropBands : IKernelBands
    {
        private const float InfraredMean = 0.25f;

        public PictureView Picture;
        public double CenterXPx;
        public double CenterYPx;
        public double SidePx;
        public double Cos;
        public double Sin;

        /// <summary>Side of the crop in its own pixels.</summary>
        public int Size;

        /// <summary>size × size × 3.</summary>
        public float* Rgb;

        /// <summary>For infrared the sum of each row.</summary>
        public float* RowSums;

        /// <param name="picture">Any format but depth.</param>
        /// <param name="region">Valid.</param>
        /// <param name="size">Side of the crop in its own pixels.</param>
        /// <param name="rgb">size × size × 3.</param>
        /// <param name="rowSums">One for each row.</param>
        public static CropBands Of(Image picture, in HandRegion region, int size, float* rgb, float* rowSums) => new CropBands
        {
            Picture = picture,
            CenterXPx = region.CenterXPx,
            CenterYPx = region.CenterYPx,
            SidePx = region.SidePx,
            Cos = Math.Cos(region.RotationRad),
            Sin = Math.Sin(region.RotationRad),
            Size = size,
            Rgb = rgb,
            RowSums = rowSums,
        };

        /// <summary>What brings infrared's mean to a quarter, from the sums of all rows.</summary>
        public float ExposureGain()
        {
            float sum = 0;
            for (int row = 0; row < Size; row++)
                sum += RowSums[row];
            return sum > 0 ? InfraredMean * (Size * Size) / sum : 0;
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public void Execute(int row)
        {
            float sum = 0;
            float* rgb = Rgb + 3L * row * Size;
            int lastX = Picture.Width - 1, lastY = Picture.Height - 1;
            PixelFormat format = Picture.Format;
            byte* pixels = Picture.Pixels;
            long stride = Picture.Stride;
            double cos = Cos, sin = Sin, step = SidePx / Size, v = (row + 0.5) * step - 0.5 * SidePx;
            double rowX = CenterXPx - v * sin - 0.5, rowY = CenterYPx + v * cos - 0.5;
            for (int i = 0; i < Size; i++, rgb += 3)
            {
                double u = (i + 0.5) * step - 0.5 * SidePx;
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
                        MixOther(Picture, left, right, top, bottom, toRight, toBottom, rgb);
                        break;
                }
            }

            RowSums[row] = sum;
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
        private static void MixOther(in PictureView picture, int left, int right, int top, int bottom, float toRight, float toBottom, float* rgb)
        {
            byte* four = stackalloc byte[16];
            Fetch(picture, left, top, four);
            Fetch(picture, right, top, four + 4);
            Fetch(picture, left, bottom, four + 8);
            Fetch(picture, right, bottom, four + 12);
            MixBgra(four, four + 8, 0, 1, toRight, toBottom, rgb);
        }

        private static void Fetch(in PictureView picture, int x, int y, byte* bgra)
        {
            byte* row = picture.Row(y);
            switch (picture.Format)
            {
                case PixelFormat.Nv12:
                    byte* chroma = picture.ChromaRow(y) + (x & ~1);
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
    }
}
