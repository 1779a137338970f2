using System;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    public sealed unsafe class ColorConversionTests
    {
        [TestCase(2)]
        [TestCase(8)]
        [TestCase(14)]
        [TestCase(250)]
        public void Kernels_AnyWidth_EqualTheScalarVersion(int width)
        {
            var random = new Random(width);
            byte[] first = new byte[width * 2];
            byte[] second = new byte[width];
            byte[] expected = new byte[width * 4 + 1];
            byte[] actual = new byte[width * 4 + 1];
            for (int n = 0; n < 200; n++)
            {
                random.NextBytes(first);
                random.NextBytes(second);
                fixed (byte* a = first, b = second, e = expected, r = actual)
                {
                    ColorConversion.Yuy2ToBgraScalar(a, e, width);
                    ColorConversion.Yuy2ToBgra(a, r, width);
                    Assert.That(actual, Is.EqualTo(expected));
                    ColorConversion.Nv12ToBgraScalar(a, b, e, width);
                    ColorConversion.Nv12ToBgra(a, b, r, width);
                    Assert.That(actual, Is.EqualTo(expected));
                }
            }
        }

        [Test]
        public void YuvToBgra_EveryColour_WithinOneOfJfif()
        {
            byte* bgra = stackalloc byte[4];
            for (int luma = 0; luma < 256; luma += 5)
            {
                for (int u = 0; u < 256; u += 3)
                {
                    for (int v = 0; v < 256; v += 3)
                    {
                        ColorConversion.YuvToBgra(luma, u, v, bgra);
                        AssertNear(bgra[0], luma + 1.772 * (u - 128));
                        AssertNear(bgra[1], luma - 0.344136 * (u - 128) - 0.714136 * (v - 128));
                        AssertNear(bgra[2], luma + 1.402 * (v - 128));
                    }
                }
            }
        }

        [TestCase(PixelFormat.Yuy2)]
        [TestCase(PixelFormat.Nv12)]
        [TestCase(PixelFormat.Gray8)]
        [TestCase(PixelFormat.Bgra32)]
        public void ToBgra_NeutralGrey_KeepsBrightnessSizeAndTime(PixelFormat format)
        {
            using (var source = new Image())
            using (var target = new Image())
            {
                source.Reset(format, 6, 4, 77);
                source.Bytes.Fill(128);
                ColorConversion.ToBgra(source, target);
                Assert.That(target.Format, Is.EqualTo(PixelFormat.Bgra32));
                Assert.That(target.Width, Is.EqualTo(6));
                Assert.That(target.Height, Is.EqualTo(4));
                Assert.That(target.TimeUs, Is.EqualTo(77));
                for (int i = 0; i < target.SizeBytes; i++)
                    Assert.That(target.Pixels[i], Is.EqualTo(i % 4 == 3 && format != PixelFormat.Bgra32 ? 255 : 128));
            }
        }

        [Test]
        public void ToBgra_Depth_Throws()
        {
            using (var source = new Image())
            using (var target = new Image())
            {
                source.Reset(PixelFormat.Depth16, 4, 4, 0);
                Assert.That(() => ColorConversion.ToBgra(source, target), Throws.ArgumentException);
            }
        }

        private static void AssertNear(byte actual, double exact)
        {
            double clamped = Math.Max(0, Math.Min(255, exact));
            if (Math.Abs(actual - clamped) > 0.51)
                Assert.Fail(actual + " is not " + clamped);
        }
    }
}
