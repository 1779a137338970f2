using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Vector kernels against their scalar form, and scalar ones against plain arithmetic, over widths around every block length.</summary>
    public sealed unsafe class ExpectationKernelTests
    {
        private static readonly int[] Widths = { 1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 32, 33, 65, 130 };

        [Test]
        public void Dilation_VectorAndScalar_AreEqualAndTheMaximumOfTheNeighbours()
        {
            foreach (int width in Widths)
            {
                const int Height = 7;
                uint[] picture = Pixels(width * Height, width), pad = new uint[width + 4], scalar = new uint[width], vector = new uint[width];
                fixed (uint* p = picture, q = pad, s = scalar, v = vector)
                {
                    for (int y = 0; y < Height; y++)
                    {
                        ExpectationKernel.DilateRow(p, width, Height, y, q, s, false);
                        ExpectationKernel.DilateRow(p, width, Height, y, q, v, true);
                        Assert.That(vector, Is.EqualTo(scalar));
                        for (int x = 0; x < width; x++)
                            Assert.That(scalar[x] >> 8 & 255, Is.EqualTo(LargestGreen(picture, width, Height, x, y)), width + " at " + x + "," + y);
                    }
                }
            }
        }

        [Test]
        public void Transfer_VectorAndScalar_AreEqual()
        {
            foreach (int width in Widths)
            {
                var tone = new byte[ExpectationKernel.ToneBytes];
                var random = new Random(width);
                for (int channel = 0; channel < 3; channel++)
                {
                    int level = 0;
                    for (int segment = 0; segment < 16; segment++)
                    {
                        tone[32 * channel + segment] = (byte)level;
                        int next = Math.Min(255, level + random.Next(40));
                        tone[32 * channel + 16 + segment] = (byte)(next - level);
                        level = next;
                    }
                }

                uint[] scalar = Pixels(width, 1), vector = (uint[])scalar.Clone(), gain = Pixels(width, 2), offset = Pixels(width, 3);
                fixed (byte* t = tone)
                fixed (uint* s = scalar, v = vector, g = gain, o = offset)
                {
                    ExpectationKernel.Transfer(s, width, t, g, o, false);
                    ExpectationKernel.Transfer(v, width, t, g, o, true);
                }

                Assert.That(vector, Is.EqualTo(scalar));
            }
        }

        [Test]
        public void Transfer_OfAStraightCurve_ChangesNothing()
        {
            var tone = new byte[ExpectationKernel.ToneBytes];
            for (int i = 0; i < 48; i++)
            {
                tone[32 * (i / 16) + i % 16] = (byte)(16 * (i % 16));
                tone[32 * (i / 16) + 16 + i % 16] = (byte)(i % 16 == 15 ? 15 : 16);
            }

            var row = new uint[256];
            for (uint i = 0; i < 256; i++)
                row[i] = i | (255 - i) << 8 | i / 2 << 16;
            uint[] gain = { 0x808080 }, offset = { 0x808080 };
            fixed (byte* t = tone)
            fixed (uint* r = row, g = gain, o = offset)
            {
                for (int i = 0; i < 240; i++)
                {
                    ExpectationKernel.Transfer(r + i, 1, t, g, o, false);
                    Assert.That(row[i] & 255, Is.EqualTo(i));
                    Assert.That(row[i] >> 16 & 255, Is.EqualTo(i / 2));
                }
            }
        }

        [Test]
        public void GatherAndExceed_VectorAndScalar_AreEqual()
        {
            foreach (int width in Widths)
            {
                uint[] source = Pixels(50, 4), scalar = new uint[2 * width], vector = new uint[2 * width], now = Pixels(2 * width, 5);
                var indices = new int[width];
                for (int i = 0; i < width; i++)
                    indices[i] = i * 7 % 50;
                byte[] scalarBytes = new byte[4 * width], vectorBytes = new byte[4 * width];
                fixed (uint* p = source, s = scalar, v = vector, n = now)
                fixed (int* i = indices)
                fixed (byte* sb = scalarBytes, vb = vectorBytes)
                {
                    ExpectationKernel.Gather(p, i, width, s, false);
                    ExpectationKernel.Gather(p, i, width, v, true);
                    ExpectationKernel.Exceed(n, s, 2 * width, sb, sb + 2 * width, false);
                    ExpectationKernel.Exceed(n, s, 2 * width, vb, vb + 2 * width, true);
                }

                Assert.That(vector, Is.EqualTo(scalar));
                Assert.That(vectorBytes, Is.EqualTo(scalarBytes));
            }
        }

        [Test]
        public void Exceed_OneChannelBrighterThanExpected_CountsThoughAnotherIsBrightest()
        {
            uint now = 0x0050C8u, expected = 0x0020F0u;
            byte reference, column = 0;
            ExpectationKernel.Exceed(&now, &expected, 1, &reference, &column, false);
            Assert.That(column, Is.EqualTo(0x30));
            Assert.That(0xC8 - reference, Is.EqualTo(0x30));
        }

        private static uint[] Pixels(int count, int seed)
        {
            var random = new Random(seed);
            var pixels = new uint[count];
            for (int i = 0; i < count; i++)
                pixels[i] = (uint)random.Next() * 2u + (uint)random.Next(2);
            return pixels;
        }

        private static uint LargestGreen(uint[] picture, int width, int height, int x, int y)
        {
            uint largest = 0;
            for (int ny = Math.Max(0, y - 2); ny <= Math.Min(height - 1, y + 2); ny++)
            {
                for (int nx = Math.Max(0, x - 2); nx <= Math.Min(width - 1, x + 2); nx++)
                    largest = Math.Max(largest, picture[ny * width + nx] >> 8 & 255);
            }

            return largest;
        }
    }
}
