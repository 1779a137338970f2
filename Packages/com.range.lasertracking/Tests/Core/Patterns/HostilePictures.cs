using System;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>Grey pictures that show no checkerboard, some of them nearly.</summary>
    internal static class HostilePictures
    {
        private const int Width = 321;
        private const int Height = 243;

        public static readonly string[] Names = { "black", "white", "noise", "stripes", "bricks", "dots", "gaps", "weave", "clutter", "gradient", "strip" };

        public static void Draw(string name, Image picture)
        {
            if (name == "clutter")
            {
                Clutter(picture, Width, Height, 7);
                return;
            }

            var random = new Random(1);
            Draw(picture, Width, Height, (x, y) =>
            {
                switch (name)
                {
                    case "white": return 255;
                    case "noise": return random.Next(256);
                    case "stripes": return (x + y / 3) / 16 % 2 * 255;
                    case "bricks": return y % 16 < 2 || (x + y / 16 * 20) % 40 < 2 ? 220 : 60;
                    case "dots": return (x % 24 - 12) * (x % 24 - 12) + (y % 24 - 12) * (y % 24 - 12) < 50 ? 20 : 230;
                    // Dark squares that do not touch each other.
                    case "gaps": return (x / 20 + y / 20) % 2 == 0 && x % 20 > 5 && y % 20 > 5 ? 20 : 230;
                    case "weave": return (int)(127 + 60 * Math.Sin(x / 2.0) + 60 * Math.Sin(y / 2.0));
                    case "gradient": return (x + y) / 3;
                    case "strip": return y < 90 || y >= 150 ? 230 : (x / 20 + y / 20) % 2 * 255;
                    default: return 0;
                }
            });
        }

        /// <summary>Rectangles of all sizes and levels over each other, with a little noise.</summary>
        public static void Clutter(Image picture, int width, int height, int seed)
        {
            var random = new Random(seed);
            Draw(picture, width, height, (x, y) => 120);
            for (int i = 0; i < 250; i++)
            {
                int left = random.Next(width), top = random.Next(height), level = random.Next(250);
                int right = Math.Min(width, left + 3 + random.Next(60)), bottom = Math.Min(height, top + 3 + random.Next(60));
                for (int y = top; y < bottom; y++)
                    picture.Bytes.Slice(y * picture.Stride + left, right - left).Fill((byte)level);
            }

            foreach (ref byte level in picture.Bytes)
                level = (byte)Math.Min(255, level + random.Next(5));
        }

        private static void Draw(Image picture, int width, int height, Func<int, int, int> level)
        {
            picture.Reset(PixelFormat.Gray8, width, height, 0);
            for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
                picture.Bytes[y * picture.Stride + x] = (byte)level(x, y);
        }
    }
}
