using System;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    public sealed class GrayConversionTests
    {
        [Test]
        public void ToGray_Colors_HaveTheLumaOfBt601()
        {
            using Image source = new Image(), gray = new Image();
            source.Reset(PixelFormat.Bgra32, 5, 3, 42, 24);
            var random = new Random(1);
            random.NextBytes(source.Bytes);
            GrayConversion.ToGray(source, gray);
            Assert.That((gray.Format, gray.Width, gray.Height, gray.TimeUs), Is.EqualTo((PixelFormat.Gray8, 5, 3, 42L)));
            for (int y = 0; y < 3; y++)
            for (int x = 0; x < 5; x++)
            {
                Span<byte> bgra = source.Bytes.Slice(y * 24 + 4 * x, 4);
                Assert.That(gray.Bytes[y * gray.Stride + x], Is.EqualTo(0.114 * bgra[0] + 0.587 * bgra[1] + 0.299 * bgra[2]).Within(1));
            }
        }

        [Test]
        public void ToGray_Infrared_SaturatesItsBrightestHundredthOnly()
        {
            using Image source = new Image(), gray = new Image();
            source.Reset(PixelFormat.Infrared16, 100, 70, 0);
            for (int i = 0; i < 7000; i++)
            {
                int level = i % 200 == 0 ? 60_000 : i % 1000;
                source.Bytes[2 * i] = (byte)level;
                source.Bytes[2 * i + 1] = (byte)(level >> 8);
            }

            GrayConversion.ToGray(source, gray);
            Assert.That(gray.Bytes[0], Is.EqualTo(255));
            Assert.That(gray.Bytes[500], Is.EqualTo(500 * 255 / 1024.0).Within(10));
            Assert.That(gray.Bytes[999], Is.InRange(225, 255));
            source.Bytes.Clear();
            GrayConversion.ToGray(source, gray);
            Assert.That(gray.Bytes[17], Is.Zero);
        }

        [TestCase(7, 5)]
        [TestCase(2, 2)]
        [TestCase(64, 33)]
        public void Halve_AnySize_GivesMeansOfFour(int width, int height)
        {
            using Image source = new Image(), half = new Image();
            source.Reset(PixelFormat.Gray8, width, height, 0, width + 3);
            new Random(2).NextBytes(source.Bytes);
            GrayConversion.Halve(source, half);
            Assert.That((half.Width, half.Height), Is.EqualTo((width / 2, height / 2)));
            for (int y = 0; y < half.Height; y++)
            for (int x = 0; x < half.Width; x++)
            {
                int at = 2 * y * source.Stride + 2 * x;
                int sum = source.Bytes[at] + source.Bytes[at + 1] + source.Bytes[at + source.Stride] + source.Bytes[at + source.Stride + 1];
                Assert.That(half.Bytes[y * half.Stride + x], Is.EqualTo((sum + 2) / 4));
            }
        }

        [Test]
        public void Conversions_OfWhatHasNoBrightness_Throw()
        {
            using Image source = new Image(), target = new Image();
            Assert.Throws<ArgumentException>(() => GrayConversion.ToGray(source, target));
            source.Reset(PixelFormat.Depth16, 8, 8, 0);
            Assert.Throws<ArgumentException>(() => GrayConversion.ToGray(source, target));
            Assert.Throws<ArgumentException>(() => GrayConversion.Halve(source, target));
            source.Reset(PixelFormat.Gray8, 1, 8, 0);
            Assert.Throws<ArgumentException>(() => GrayConversion.Halve(source, target));
            source.Reset(PixelFormat.Gray8, 8, 8, 0);
            Assert.Throws<ArgumentException>(() => GrayConversion.Halve(source, source));
        }
    }
}
