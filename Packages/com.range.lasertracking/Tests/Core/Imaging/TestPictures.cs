using System;

namespace LaserTracking.Imaging
{
    /// <summary>Computed pictures with smooth parts, edges and some noise, the same on every machine.</summary>
    internal static unsafe class TestPictures
    {
        public static void Fill(Image image, PixelFormat format, int width, int height, int seed = 1)
        {
            image.Reset(format, width, height, 1000);
            var random = new Random(seed);
            int bytesPerPixel = image.Stride / width;
            int rows = image.SizeBytes / image.Stride;
            for (int y = 0; y < rows; y++)
            {
                for (int x = 0; x < image.Stride; x++)
                {
                    int column = x / bytesPerPixel;
                    int channel = x % bytesPerPixel;
                    double value = 120 + 60 * Math.Sin(0.05 * column + channel) + 50 * Math.Cos(0.07 * y - channel) + random.Next(-3, 4);
                    if ((column / 24 + y / 20) % 5 == 0)
                        value = 230;
                    image.Pixels[(long)y * image.Stride + x] = (byte)Math.Max(0, Math.Min(255, value));
                }
            }

            if (format == PixelFormat.Bgra32)
            {
                for (int i = 3; i < image.SizeBytes; i += 4)
                    image.Pixels[i] = 255;
            }
        }

        public static double MeanDifference(Image a, Image b)
        {
            long sum = 0;
            for (int i = 0; i < a.SizeBytes; i++)
                sum += Math.Abs(a.Pixels[i] - b.Pixels[i]);
            return (double)sum / a.SizeBytes;
        }
    }
}
