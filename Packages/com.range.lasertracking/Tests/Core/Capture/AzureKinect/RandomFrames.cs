using System;
using System.Collections.Generic;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Frames of noise for tests of recordings: any pictures, sizes, times; equal seeds, equal frames.</summary>
    internal static class RandomFrames
    {
        public static readonly PixelFormat[] Colors = { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8 };

        /// <summary>A stream's frames; the first has every kind of picture that any has, later ones lack some.</summary>
        public static List<Frame> Create(int seed, int count, long startUs = -1)
        {
            var random = new Random(seed);
            PixelFormat color = Colors[random.Next(Colors.Length)];
            int kinds = 1 + random.Next(7);
            (int w, int h) = (2 + 2 * random.Next(12), 2 + 2 * random.Next(9));
            (int dw, int dh) = (1 + random.Next(20), 1 + random.Next(20));
            long timeUs = startUs >= 0 ? startUs : random.Next(2) == 0 ? random.Next() : 1730796756988167L;
            var frames = new List<Frame>();
            for (int i = 0; i < count; i++, timeUs += 33333 + random.Next(-3000, 3000))
            {
                int present = i == 0 ? kinds : kinds & random.Next(8);
                if (present == 0)
                    present = kinds;
                var frame = new Frame();
                frame.Begin(i, timeUs);
                if ((present & 1) != 0)
                    Fill(random, frame.Color, color, w, h, timeUs);
                if ((present & 2) != 0)
                    Fill(random, frame.Depth, PixelFormat.Depth16, dw, dh, timeUs + (i == 0 ? 0 : random.Next(-2000, 2000)));
                if ((present & 4) != 0)
                    Fill(random, frame.Infrared, PixelFormat.Infrared16, dw, dh, timeUs + (i == 0 ? 0 : random.Next(-2000, 2000)));
                frames.Add(frame);
            }

            return frames;
        }

        public static void Fill(Random random, Image image, PixelFormat format, int width, int height, long timeUs)
        {
            image.Reset(format, width, height, timeUs);
            random.NextBytes(image.Bytes);
        }
    }
}
