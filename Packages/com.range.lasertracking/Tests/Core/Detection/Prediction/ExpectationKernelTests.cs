using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Vector kernels against their scalar form, and scalar ones against plain arithmetic, over widths around every block length.</summary>
    public sealed unsafe class ExpectationKernelTests
    {
        private static readonly int[] Widths = { 1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 32, 33, 65, 130 };

        [Test]
        public void Expectation_VectorAndScalarInBands_AreEqualAndTheMaximumOfTheNeighboursInAllPictures()
        {
            foreach (int width in Widths)
            {
                foreach (int height in new[] { 1, 2, 4, 5, 11 })
                {
                    var pictures = new uint[3][];
                    for (int i = 0; i < pictures.Length; i++)
                        pictures[i] = Array.ConvertAll(Pixels(width * height, width + i), pixel => pixel & 0x7F7F7F7Fu);
                    uint[] scalar = Expect(pictures, width, height, 1, false);
                    Assert.That(Expect(pictures, width, height, 1, true), Is.EqualTo(scalar));
                    Assert.That(Expect(pictures, width, height, 3, true), Is.EqualTo(scalar));
                    for (int y = 0; y < height; y++)
                    {
                        for (int x = 0; x < width; x++)
                            Assert.That(scalar[y * width + x] >> 8 & 255, Is.EqualTo(LargestGreen(pictures, width, height, x, y)), width + "×" + height + " at " + x + "," + y);
                    }
                }
            }
        }

        [Test]
        public void Apart_VectorAndScalar_AreEqualAndTheLargestDifference()
        {
            const int Width = 7, Middle = 3 * Width + 3;
            for (int seed = 0; seed < 200; seed++)
            {
                // Most differ by little, one by more, and what is no colour by anything.
                uint[] picture = Array.ConvertAll(Pixels(7 * Width, seed), pixel => 0x404040u + (pixel & 0xFF030303u));
                picture[new[] { Middle, Middle - 2, Middle + 2, Middle - 2 * Width, Middle + 2 * Width, Middle + 1 }[seed % 6]] += (uint)seed << 8 * (seed % 3);
                uint value = picture[0] & 0xFF434343u;
                fixed (uint* p = picture)
                {
                    int scalar = ExpectationKernel.Apart(value, p + Middle, 2, Width, false);
                    Assert.That(ExpectationKernel.Apart(value, p + Middle, 2, Width, true), Is.EqualTo(scalar));
                    int largest = 0;
                    foreach (int at in new[] { Middle, Middle - 2, Middle + 2, Middle - 2 * Width, Middle + 2 * Width })
                    {
                        for (int shift = 0; shift < 24; shift += 8)
                            largest = Math.Max(largest, Math.Abs((int)(p[at] >> shift & 255) - (int)(value >> shift & 255)));
                    }

                    Assert.That(scalar, Is.EqualTo(largest));
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
            byte[] tone = StraightTone();
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

        private static byte[] StraightTone()
        {
            var tone = new byte[ExpectationKernel.ToneBytes];
            for (int i = 0; i < 48; i++)
            {
                tone[32 * (i / 16) + i % 16] = (byte)(16 * (i % 16));
                tone[32 * (i / 16) + 16 + i % 16] = (byte)(i % 16 == 15 ? 15 : 16);
            }

            return tone;
        }

        /// <summary>With a transfer that changes nothing.</summary>
        private static uint[] Expect(uint[][] pictures, int width, int height, int bands, bool useVectors)
        {
            var result = new uint[width * height];
            uint[] same = Array.ConvertAll(result, pixel => 0x808080u), scratch = new uint[bands * ExpectationBands.ScratchLength(width)];
            fixed (uint* first = pictures[0], second = pictures[1], third = pictures[2], target = result, gain = same, rows = scratch)
            fixed (byte* tone = StraightTone())
            {
                uint** all = stackalloc uint*[] { first, second, third };
                var work = new ExpectationBands
                {
                    Width = width,
                    Height = height,
                    PictureCount = pictures.Length,
                    UseVectors = useVectors,
                    BandCount = bands,
                    Pictures = all,
                    Screen = target,
                    Tone = tone,
                    Gain = gain,
                    Offset = gain,
                    Scratch = rows,
                };
                for (int band = bands - 1; band >= 0; band--)
                    work.Execute(band);
            }

            return result;
        }

        private static uint LargestGreen(uint[][] pictures, int width, int height, int x, int y)
        {
            uint largest = 0;
            for (int ny = Math.Max(0, y - 2); ny <= Math.Min(height - 1, y + 2); ny++)
            {
                for (int nx = Math.Max(0, x - 2); nx <= Math.Min(width - 1, x + 2); nx++)
                {
                    foreach (uint[] picture in pictures)
                        largest = Math.Max(largest, picture[ny * width + nx] >> 8 & 255);
                }
            }

            return largest;
        }
    }
}
