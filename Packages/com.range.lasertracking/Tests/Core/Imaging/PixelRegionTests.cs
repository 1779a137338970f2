using System;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    public sealed class PixelRegionTests
    {
        [Test]
        public void TryCreate_AnyRectangle_HoldsItAndLiesInThePicture()
        {
            var random = new Random(1);
            for (int i = 0; i < 5000; i++)
            {
                int w = 2 * (1 + random.Next(400)), h = 2 * (1 + random.Next(400));
                double left = random.NextDouble() * 1000 - 100, top = random.NextDouble() * 1000 - 100;
                double right = left + random.NextDouble() * 500, bottom = top + random.NextDouble() * 500;
                bool touches = left < w && top < h && right > 0 && bottom > 0;
                Assert.That(PixelRegion.TryCreate(left, top, right, bottom, w, h, out PixelRegion region), Is.EqualTo(touches));
                if (!touches)
                    continue;
                Assert.That(region.X <= Math.Max(0, left) && region.Y <= Math.Max(0, top));
                Assert.That(region.X + region.Width >= Math.Min(w, right) && region.Y + region.Height >= Math.Min(h, bottom));
                Assert.That(region.X + region.Width <= w && region.Y + region.Height <= h && region.X >= 0 && region.Y >= 0);
                Assert.That((region.X | region.Y | region.Width | region.Height) % 2, Is.Zero);
                Assert.That(PixelRegion.TryParse(region.ToString(), out PixelRegion read) && read.Equals(region), Is.True);
            }
        }

        [Test]
        public void TryParse_AnythingElse_IsRefused(
            [Values("", "1 2 3", "0 0 4 4 8 x", "0 0 0 4 8 8", "1 0 4 4 8 8", "4 0 6 4 8 8", "0 0 4 4 7 8", "-2 0 4 4 8 8", "0 0 99999999 4 99999999 8", "0  0 4 4 8 8", "0 0 4 4 8 8 8")] string text) =>
            Assert.That(PixelRegion.TryParse(text, out _), Is.False);

        [Test]
        public void Restore_OfACrop_IsThePictureInsideAndBlackOutside()
        {
            var random = new Random(2);
            foreach (PixelFormat format in new[] { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8 })
            {
                using var picture = new Image();
                using var part = new Image();
                using var restored = new Image();
                picture.Reset(format, 30, 20, 7, Image.TightStride(format, 30) + 16);
                random.NextBytes(picture.Bytes);
                Assert.That(PixelRegion.TryCreate(4, 6, 20, 16, 30, 20, out PixelRegion region), Is.True);
                region.Crop(picture, part);
                region.Restore(part, restored);
                int unit = Image.TightStride(format, 2) / 2;
                for (int y = 0; y < 20; y++)
                for (int x = 0; x < 30 * unit; x++)
                {
                    bool inside = y >= 6 && y < 16 && x >= 4 * unit && x < 20 * unit;
                    byte black = format == PixelFormat.Yuy2 && x % 2 == 1 ? (byte)128 : (byte)0;
                    Assert.That(restored.Bytes[y * restored.Stride + x], Is.EqualTo(inside ? picture.Bytes[y * picture.Stride + x] : black), format + " " + x + "," + y);
                }

                if (format != PixelFormat.Nv12)
                    continue;
                for (int y = 20; y < 30; y++)
                for (int x = 0; x < 30; x++)
                {
                    bool inside = y >= 23 && y < 28 && x >= 4 && x < 20;
                    Assert.That(restored.Bytes[y * 30 + x], Is.EqualTo(inside ? picture.Bytes[y * picture.Stride + x] : (byte)128), "chroma " + x + "," + y);
                }
            }
        }

        [Test]
        public void Crop_PictureOfAnotherSize_Throws()
        {
            using var picture = new Image();
            picture.Reset(PixelFormat.Gray8, 10, 10, 0);
            PixelRegion.TryCreate(0, 0, 2, 2, 8, 8, out PixelRegion region);
            Assert.Throws<ArgumentException>(() => region.Crop(picture, new Image()));
        }
    }
}
