using System;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    public sealed unsafe class JpegDecoderTests
    {
        /// <summary>16×16, 4:4:4 stated as 1×2 for each component, no Huffman tables; written by FFmpeg's encoder.</summary>
        private const string Picture444 =
            "/9j/2wBDAAgEBAQEBAUFBQUFBQYGBgYGBgYGBgYGBgYHBwcICAgHBwcGBgcHCAgICAkJCQgICAgJCQoKCgwMCwsODg4RERT/wAARCAAQABADARIAAhIAAxIA"
            + "/9oADAMBAAIRAxEAPwDy6Z/EV7rVzZaYdwhiNw+77NHFBDHCryzTT3G2OKNc8vLIq5IXOSBW/wCGpYJLjxbp5j+1XFz/AGJPFYhzHJexWbebcxROOd/lchUz"
            + "KRkopwa+14047xfDmbYmKzGnRwsOTkUFGrv25Xr8j8fzRV7ZLipVpxpUZzdarOUqnLd6XUm+Y93E1M0njauHw90uW1pLltddXLY97jerh1neb4H2anXxMKHs"
            + "KMfcdTlWvvLYxvCP/Cd+HddaCy/0a5Nol/5o/s+a1NmYZSLsXUnmWZt9rlfOEvl7zszv4rqtOutPTwavhj7F5WpjdqX/AAjhuJDdR2T6s18tmZ8bvtH2L5vK"
            + "J+2bPnMWa/R858T6+ZZZGtWzNVKH8vsuWp/4L+L8D88xGFxz4tWf/Wr5Y4RSx3L+70jb/d9t9Nj4nGcP4/FcO57kMqF6OYSoyxFPnUY1HTlzRaq7Kz10PoMV"
            + "7OpwhWyqOFcsbFrmwnPae9/42/4n/9k=";

        private readonly JpegDecoder _decoder = new JpegDecoder();
        private readonly Image _source = new Image();
        private readonly Image _decoded = new Image();

        [OneTimeTearDown]
        public void FreeImages()
        {
            _source.Dispose();
            _decoded.Dispose();
        }

        [TestCase(PixelFormat.Yuy2, 64, 32, 0)]
        [TestCase(PixelFormat.Yuy2, 150, 53, 0)]
        [TestCase(PixelFormat.Yuy2, 150, 53, 3)]
        [TestCase(PixelFormat.Nv12, 64, 32, 0)]
        [TestCase(PixelFormat.Nv12, 150, 54, 1)]
        [TestCase(PixelFormat.Nv12, 2, 2, 0)]
        [TestCase(PixelFormat.Gray8, 64, 32, 0)]
        [TestCase(PixelFormat.Gray8, 151, 53, 5)]
        [TestCase(PixelFormat.Gray8, 1, 1, 0)]
        public void TryDecode_EncodedPicture_ReturnsItsFormatAndNearlyItsPixels(PixelFormat format, int width, int height, int restarts)
        {
            TestPictures.Fill(_source, format, width, height);
            byte[] jpeg = new JpegEncoder(98, restarts).Encode(_source).ToArray();
            Assert.That(_decoder.TryDecode(jpeg, _decoded, 4242, out string problem), Is.True, problem);
            Assert.That(problem, Is.Empty);
            Assert.That(_decoded.Format, Is.EqualTo(format));
            Assert.That(_decoded.Width, Is.EqualTo(width));
            Assert.That(_decoded.Height, Is.EqualTo(height));
            Assert.That(_decoded.TimeUs, Is.EqualTo(4242));
            Assert.That(TestPictures.MeanDifference(_source, _decoded), Is.LessThan(1.5));
        }

        [Test]
        public void TryDecode_OddWidth422_BecomesBgra()
        {
            TestPictures.Fill(_source, PixelFormat.Bgra32, 37, 21);
            _source.Bytes.Fill(0);
            for (int i = 0; i < _source.SizeBytes; i += 4)
                _source.Pixels[i + 2] = 200;
            byte[] jpeg = new JpegEncoder(95).Encode(_source).ToArray();
            Assert.That(_decoder.TryDecode(jpeg, _decoded, 0, out string problem), Is.True, problem);
            Assert.That(_decoded.Format, Is.EqualTo(PixelFormat.Bgra32));
            Assert.That(_decoded.Width, Is.EqualTo(37));
            byte* last = _decoded.Pixels + _decoded.SizeBytes - 4;
            Assert.That(last[0], Is.LessThan(4));
            Assert.That(last[1], Is.LessThan(4));
            Assert.That((int)last[2], Is.InRange(196, 204));
            Assert.That(last[3], Is.EqualTo(255));
        }

        [Test]
        public void TryDecode_WithoutHuffmanTables_UsesTheStandardOnesAgain()
        {
            TestPictures.Fill(_source, PixelFormat.Yuy2, 64, 32);
            byte[] without = new JpegEncoder(90, 0, false).Encode(_source).ToArray();
            byte[] with = new JpegEncoder(90).Encode(_source).ToArray();
            using (var expected = new Image())
            {
                Assert.That(_decoder.TryDecode(with, expected, 0, out _), Is.True);

                // A picture with tables of its own in between must leave no trace.
                byte[] odd = (byte[])with.Clone();
                odd[FindSegment(odd, 0xC4) + 5 + 16] = 3;
                _decoder.TryDecode(odd, _decoded, 0, out _);
                Assert.That(_decoder.TryDecode(without, _decoded, 0, out string problem), Is.True, problem);
                Assert.That(_decoded.Bytes.SequenceEqual(expected.Bytes), Is.True);
            }
        }

        [Test]
        public void TryDecode_RestartMarkers_ChangeNothingButTheMarkers()
        {
            TestPictures.Fill(_source, PixelFormat.Nv12, 160, 96);
            using (var expected = new Image())
            {
                Assert.That(_decoder.TryDecode(new JpegEncoder(80).Encode(_source), expected, 0, out _), Is.True);
                Assert.That(_decoder.TryDecode(new JpegEncoder(80, 2).Encode(_source), _decoded, 0, out string problem), Is.True, problem);
                Assert.That(_decoded.Bytes.SequenceEqual(expected.Bytes), Is.True);
            }
        }

        [Test]
        public void TryDecode_444FromAnotherEncoder_HasItsColours()
        {
            Assert.That(_decoder.TryDecode(Convert.FromBase64String(Picture444), _decoded, 0, out string problem), Is.True, problem);
            Assert.That(_decoded.Format, Is.EqualTo(PixelFormat.Bgra32));

            // FFmpeg's own planes, converted by JFIF's equations in floating point.
            int[,] expected =
            {
                { 0, 0, 249, 4, 132 }, { 5, 2, 94, 0, 44 }, { 9, 4, 71, 2, 0 }, { 14, 1, 252, 206, 88 }, { 3, 8, 0, 7, 63 },
                { 8, 8, 31, 1, 14 }, { 12, 11, 0, 126, 255 }, { 1, 15, 13, 11, 231 }, { 15, 15, 23, 138, 225 }, { 7, 13, 14, 58, 65 },
            };
            for (int i = 0; i < expected.GetLength(0); i++)
            {
                byte* pixel = _decoded.Pixels + expected[i, 1] * _decoded.Stride + expected[i, 0] * 4;
                for (int c = 0; c < 3; c++)
                    Assert.That(Math.Abs(pixel[c] - expected[i, 2 + c]), Is.LessThanOrEqualTo(2), "pixel " + i + " channel " + c);
            }
        }

        [Test]
        public void TryDecode_444FromAnotherEncoder_EqualsLibjpegToTheBit()
        {
            // FNV-1a over the pixels that Chromium (libjpeg-turbo) decodes from the same bytes.
            Assert.That(_decoder.TryDecode(Convert.FromBase64String(Picture444), _decoded, 0, out string problem), Is.True, problem);
            ulong hash = 14695981039346656037;
            foreach (byte value in _decoded.Bytes)
                hash = unchecked((hash ^ value) * 1099511628211);
            Assert.That(hash, Is.EqualTo(0xa849467df7b8e1b8));
        }

        [Test]
        public void TryDecode_CommentsAndFillBytes_AreSkipped()
        {
            TestPictures.Fill(_source, PixelFormat.Gray8, 16, 16);
            byte[] jpeg = new JpegEncoder().Encode(_source).ToArray();
            byte[] extra = { 0xFF, 0xE1, 0, 6, 0xFF, 0xD8, 0xFF, 0xD9, 0xFF, 0xFF, 0xFF, 0xFE, 0, 3, 65 };
            byte[] longer = new byte[jpeg.Length + extra.Length + 4];
            Array.Copy(jpeg, longer, 2);
            extra.CopyTo(longer, 2);
            Array.Copy(jpeg, 2, longer, 2 + extra.Length, jpeg.Length - 2);
            Assert.That(_decoder.TryDecode(longer, _decoded, 0, out string problem), Is.True, problem);
            Assert.That(TestPictures.MeanDifference(_source, _decoded), Is.LessThan(4));
        }

        [Test]
        public void TryDecode_CutAnywhere_FailsWithTheByte()
        {
            TestPictures.Fill(_source, PixelFormat.Yuy2, 64, 48);
            byte[] jpeg = new JpegEncoder(90, 4).Encode(_source).ToArray();
            for (int length = 0; length < jpeg.Length - 4; length++)
            {
                Assert.That(_decoder.TryDecode(new ReadOnlySpan<byte>(jpeg, 0, length), _decoded, 0, out string problem), Is.False);
                Assert.That(_decoded.IsPresent, Is.False);
                Assert.That(problem, Is.Not.Empty);
                if (length > 4)
                    Assert.That(problem, Does.StartWith("JPEG ends early at byte " + length).Or.StartWith("JPEG damaged at byte"));
            }

            _decoder.TryDecode(new ReadOnlySpan<byte>(jpeg, 0, jpeg.Length / 2), _decoded, 0, out string half);
            Assert.That(half, Is.EqualTo("JPEG ends early at byte " + jpeg.Length / 2));
        }

        [Test]
        public void TryDecode_RestartMarkerMissing_IsDamage()
        {
            TestPictures.Fill(_source, PixelFormat.Yuy2, 64, 48);
            byte[] jpeg = new JpegEncoder(90, 4).Encode(_source).ToArray();
            int marker = Array.FindIndex(jpeg, 400, b => b == 0xFF);
            while (jpeg[marker + 1] != 0xD1)
                marker = Array.FindIndex(jpeg, marker + 1, b => b == 0xFF);
            jpeg[marker + 1] = 0xD2;
            Assert.That(_decoder.TryDecode(jpeg, _decoded, 0, out string problem), Is.False);
            Assert.That(problem, Does.StartWith("JPEG damaged at byte"));
        }

        [TestCase(0xC2, "progressive")]
        [TestCase(0xC9, "arithmetic")]
        [TestCase(0xC3, "lossless")]
        public void TryDecode_OtherProcesses_AreRefusedByName(int startOfFrame, string word)
        {
            TestPictures.Fill(_source, PixelFormat.Gray8, 16, 16);
            byte[] jpeg = new JpegEncoder().Encode(_source).ToArray();
            jpeg[FindSegment(jpeg, 0xC0) + 1] = (byte)startOfFrame;
            Assert.That(_decoder.TryDecode(jpeg, _decoded, 0, out string problem), Is.False);
            Assert.That(problem, Does.Contain(word));
        }

        [Test]
        public void TryDecode_TwelveBit_IsRefused()
        {
            TestPictures.Fill(_source, PixelFormat.Gray8, 16, 16);
            byte[] jpeg = new JpegEncoder().Encode(_source).ToArray();
            jpeg[FindSegment(jpeg, 0xC0) + 4] = 12;
            Assert.That(_decoder.TryDecode(jpeg, _decoded, 0, out string problem), Is.False);
            Assert.That(problem, Does.Contain("12 bits"));
        }

        [Test]
        public void TryDecode_HugeDeclaredSize_IsRefusedWithoutMakingRoom()
        {
            TestPictures.Fill(_source, PixelFormat.Yuy2, 64, 48);
            byte[] jpeg = new JpegEncoder().Encode(_source).ToArray();
            int size = FindSegment(jpeg, 0xC0) + 5;
            jpeg[size] = jpeg[size + 1] = jpeg[size + 2] = 0xFF;
            jpeg[size + 3] = 0xFE;
            Assert.That(_decoder.TryDecode(jpeg, _decoded, 0, out string problem), Is.False);
            Assert.That(problem, Is.EqualTo("JPEG ends early at byte " + jpeg.Length));
        }

        [Test]
        public void TryDecode_Empty_SaysSo()
        {
            Assert.That(_decoder.TryDecode(default, _decoded, 0, out string problem), Is.False);
            Assert.That(problem, Is.EqualTo("JPEG is empty"));
            Assert.That(_decoder.TryDecode(new byte[100], _decoded, 0, out problem), Is.False);
            Assert.That(problem, Does.StartWith("not a JPEG"));
        }

        [Test]
        public void TryDecode_Warm_AllocatesNothing()
        {
            TestPictures.Fill(_source, PixelFormat.Yuy2, 320, 240);
            byte[] first = new JpegEncoder(90, 10).Encode(_source).ToArray();
            byte[] second = new JpegEncoder(70, 0, false).Encode(_source).ToArray();
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 10; i++)
                {
                    _decoder.TryDecode(first, _decoded, 0, out _);
                    _decoder.TryDecode(second, _decoded, 0, out _);
                }
            });
            Assert.That(allocated, Is.Zero);
        }

        [Test]
        public void Encode_SameOrWarm_SameBytesAndNoAllocation()
        {
            TestPictures.Fill(_source, PixelFormat.Bgra32, 320, 240);
            var encoder = new JpegEncoder(85);
            byte[] first = encoder.Encode(_source).ToArray();
            int length = 0;
            long allocated = Allocation.Of(() => length = encoder.Encode(_source).Length);
            Assert.That(allocated, Is.Zero);
            Assert.That(length, Is.EqualTo(first.Length));
            Assert.That(new JpegEncoder(85).Encode(_source).SequenceEqual(first), Is.True);
        }

        /// <summary>Offset of the first segment with this marker.</summary>
        internal static int FindSegment(byte[] jpeg, int marker)
        {
            int at = 2;
            while (jpeg[at + 1] != marker)
                at += 2 + (jpeg[at + 2] << 8 | jpeg[at + 3]);
            return at;
        }
    }
}
