using System;

namespace LaserTracking.Imaging
{
    /// <summary>Raw pictures to one byte of brightness a pixel, and that to half its size.</summary>
    public static unsafe class GrayConversion
    {
        /// <summary>
        /// The brightness of any picture but depth, same size and time: luma as it is, BT.601 luma of colours, infrared scaled so that
        /// only its brightest hundredth saturates.
        /// </summary>
        /// <exception cref="ArgumentException">No picture, depth, or both arguments are the same picture.</exception>
        public static void ToGray(Image source, Image target)
        {
            if (source.Format == PixelFormat.None || source.Format == PixelFormat.Depth16 || ReferenceEquals(source, target))
                throw new ArgumentException($"a picture of format {source.Format} has no brightness to convert", nameof(source));
            target.Reset(PixelFormat.Gray8, source.Width, source.Height, source.TimeUs);
            int white = source.Format == PixelFormat.Infrared16 ? InfraredWhite(source) : 0;
            for (int y = 0; y < source.Height; y++)
            {
                byte* from = source.Pixels + (long)y * source.Stride;
                byte* to = target.Pixels + (long)y * target.Stride;
                switch (source.Format)
                {
                    case PixelFormat.Yuy2:
                        for (int x = 0; x < source.Width; x++)
                            to[x] = from[2 * x];
                        break;
                    case PixelFormat.Bgra32:
                        for (int x = 0; x < source.Width; x++)
                            to[x] = (byte)((29 * from[4 * x] + 150 * from[4 * x + 1] + 77 * from[4 * x + 2] + 128) >> 8);
                        break;
                    case PixelFormat.Infrared16:
                        for (int x = 0; x < source.Width; x++)
                            to[x] = (byte)Math.Min(255, ((ushort*)from)[x] * 255 / white);
                        break;
                    default:
                        Buffer.MemoryCopy(from, to, target.Stride, source.Width);
                        break;
                }
            }
        }

        /// <summary>
        /// Means of 2×2 pixels of a <see cref="PixelFormat.Gray8"/> picture; an odd last row or column is left out. A place (x, y) there
        /// is (2x + ½, 2y + ½) here.
        /// </summary>
        /// <exception cref="ArgumentException">Another format, less than two pixels either way, or both arguments are the same picture.</exception>
        public static void Halve(Image source, Image target)
        {
            if (source.Format != PixelFormat.Gray8 || source.Width < 2 || source.Height < 2 || ReferenceEquals(source, target))
                throw new ArgumentException($"a picture of format {source.Format}, {source.Width}×{source.Height}, cannot be halved", nameof(source));
            target.Reset(PixelFormat.Gray8, source.Width / 2, source.Height / 2, source.TimeUs);
            for (int y = 0; y < target.Height; y++)
            {
                byte* above = source.Pixels + 2L * y * source.Stride, below = above + source.Stride;
                byte* to = target.Pixels + (long)y * target.Stride;
                for (int x = 0; x < target.Width; x++)
                    to[x] = (byte)((above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1] + 2) >> 2);
            }
        }

        /// <summary>The level that one pixel in a hundred exceeds, from every seventh pixel; at least 1.</summary>
        private static int InfraredWhite(Image source)
        {
            const int Step = 7, Bins = 1024, Shift = 6;
            int* histogram = stackalloc int[Bins];
            new Span<int>(histogram, Bins).Clear();
            int count = 0;
            for (int y = 0; y < source.Height; y++)
            {
                ushort* row = (ushort*)(source.Pixels + (long)y * source.Stride);
                for (int x = y % Step; x < source.Width; x += Step, count++)
                    histogram[row[x] >> Shift]++;
            }

            int bin = Bins - 1;
            for (int above = 0; bin > 0 && (above += histogram[bin]) <= count / 100;)
                bin--;
            return (bin + 1) << Shift;
        }
    }
}
