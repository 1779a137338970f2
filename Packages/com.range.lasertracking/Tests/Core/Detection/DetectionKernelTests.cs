using System;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Vector kernels against their scalar form, over sizes around every block length; scalar ones against plain arithmetic.</summary>
    public sealed unsafe class DetectionKernelTests
    {
        private static readonly int[] Widths = { 1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 32, 33, 63, 64, 65, 66, 127, 130 };

        [TestCase(PixelFormat.Bgra32, 1)]
        [TestCase(PixelFormat.Bgra32, 2)]
        [TestCase(PixelFormat.Nv12, 1)]
        [TestCase(PixelFormat.Nv12, 2)]
        [TestCase(PixelFormat.Yuy2, 1)]
        [TestCase(PixelFormat.Yuy2, 2)]
        [TestCase(PixelFormat.Gray8, 2)]
        public void Reduction_VectorAndScalar_AreEqualAndTheMaximumOfTheirPixels(PixelFormat format, int factor)
        {
            var random = new Random(7);
            foreach (int width in Widths)
            {
                if (format != PixelFormat.Bgra32 && format != PixelFormat.Gray8 && width % 2 != 0)
                    continue;
                using (var image = new Image())
                {
                    int height = format == PixelFormat.Nv12 ? 4 : 5;
                    image.Reset(format, width, height, 0);
                    random.NextBytes(image.Bytes);
                    int reduced = ReductionKernel.ReducedSize(width, factor);
                    var scalar = new uint[reduced];
                    var vector = new uint[reduced];
                    for (int y = 0; y < ReductionKernel.ReducedSize(height, factor); y++)
                    {
                        fixed (uint* s = scalar, v = vector)
                        {
                            ReductionKernel.Row(image, y, factor, s, false);
                            ReductionKernel.Row(image, y, factor, v, true);
                        }

                        Assert.That(vector, Is.EqualTo(scalar), format + " " + width);
                        for (int x = 0; x < reduced; x++)
                            Assert.That(scalar[x] & 0xFFFFFF, Is.EqualTo(Reference(image, x, y, factor)), format + " " + width + " at " + x + "," + y);
                    }
                }
            }
        }

        [Test]
        public void Envelope_VectorAndScalar_AreEqual()
        {
            var random = new Random(9);
            foreach (int width in Widths)
            {
                var pixels = new uint[width];
                var old = new byte[2 * width];
                for (int i = 0; i < width; i++)
                    pixels[i] = (uint)random.Next() * 2u + (uint)random.Next(2);
                random.NextBytes(old);
                var scalar = new byte[4 * width];
                random.NextBytes(scalar);
                var vector = (byte[])scalar.Clone();
                fixed (uint* p = pixels)
                fixed (byte* o = old, s = scalar, v = vector)
                {
                    EnvelopeKernel.Row(p, width, 6, o, s, o + width, s + width, s + 2 * width, s + 3 * width, false);
                    EnvelopeKernel.Row(p, width, 6, o, v, o + width, v + width, v + 2 * width, v + 3 * width, true);
                }

                Assert.That(vector, Is.EqualTo(scalar), "width " + width);
                int smallest = (int)Math.Min(pixels[0] & 255, Math.Min(pixels[0] >> 8 & 255, pixels[0] >> 16 & 255));
                Assert.That(scalar[0], Is.EqualTo(Math.Max(smallest, old[0] - 6)));
            }
        }

        [Test]
        public void Smoothing_VectorAndScalar_AreEqualAndKeepAConstant()
        {
            var random = new Random(11);
            foreach (int width in Widths)
            {
                var rows = new uint[3 * width];
                for (int i = 0; i < rows.Length; i++)
                    rows[i] = (uint)random.Next() * 2u;
                var scalar = new uint[2 * width];
                var vector = new uint[2 * width];
                fixed (uint* r = rows, s = scalar, v = vector)
                {
                    SmoothingKernel.Horizontal(r, width, s, false);
                    SmoothingKernel.Horizontal(r, width, v, true);
                    SmoothingKernel.Vertical(r, r + width, r + 2 * width, width, s + width, false);
                    SmoothingKernel.Vertical(r, r + width, r + 2 * width, width, v + width, true);
                }

                Assert.That(vector, Is.EqualTo(scalar), "width " + width);
            }

            var flat = new uint[] { 0x01FF7F80, 0x01FF7F80, 0x01FF7F80 };
            var result = new uint[3];
            fixed (uint* f = flat, t = result)
                SmoothingKernel.Horizontal(f, 3, t, true);
            Assert.That(result, Is.EqualTo(flat));
        }

        [Test]
        public void Rises_OfATile_AreSharesOfTheRoomAndTheirRowsPeaks([Values] bool ofLargest, [Values(16, 15, 3)] int width, [Values(16, 13, 1)] int height)
        {
            const int Stride = 21;
            DetectionPlane plane = ofLargest ? DetectionPlane.Largest : DetectionPlane.Smallest;
            var random = new Random(13);
            var now = new uint[Stride * TileGrid.Size];
            var past = new byte[now.Length];
            byte[] rises = new byte[TileGrid.Size * TileGrid.Size], peaks = new byte[TileGrid.Size], expected = new byte[rises.Length], expectedPeaks = new byte[peaks.Length];
            int[] reciprocal = FrameView.Reciprocals();
            for (int i = 0; i < now.Length; i++)
            {
                now[i] = (uint)random.Next() * 2u + (uint)random.Next(2);
                past[i] = (byte)(random.Next(3) == 0 ? random.Next(256) : random.Next(90));
            }

            fixed (uint* n = now)
            fixed (byte* p = past, r = rises, peak = peaks)
            fixed (int* table = reciprocal)
            {
                RiseKernel.Tile(n, p, Stride, plane, table, width, height, r, peak);
                for (int y = 0; y < height; y++)
                {
                    for (int x = 0; x < width; x++)
                    {
                        byte rise = (byte)FrameView.RelativeRise(now[y * Stride + x], plane, past[y * Stride + x], table);
                        expected[y * TileGrid.Size + x] = rise;
                        expectedPeaks[y] = Math.Max(expectedPeaks[y], rise);
                    }
                }
            }

            Assert.That(rises, Is.EqualTo(expected));
            Assert.That(peaks, Is.EqualTo(expectedPeaks));
        }

        [Test]
        public void Onsets_OfARow_AreTheLargestOfEachTile()
        {
            var random = new Random(15);
            foreach (int width in Widths)
            {
                var columns = new byte[width];
                random.NextBytes(columns);
                byte[] onsets = new byte[TileGrid.Count(width)], expected = new byte[onsets.Length];
                for (int x = 0; x < width; x++)
                    expected[x / TileGrid.Size] = Math.Max(expected[x / TileGrid.Size], columns[x]);
                fixed (byte* c = columns, o = onsets)
                    TileGrid.ReduceRow(c, width, o);
                Assert.That(onsets, Is.EqualTo(expected), "width " + width);
            }
        }

        [Test]
        public void ToBgra_PartOfARowOfAnyWidth_IsThatPartMadeOpaqueAndNoMore()
        {
            using var image = new Image();
            image.Reset(PixelFormat.Bgra32, 70, 2, 0);
            new Random(9).NextBytes(image.Bytes);
            var source = (uint*)image.Pixels + 70;
            for (int from = 0; from < 3; from++)
            {
                for (int to = from; to <= 70; to++)
                {
                    var row = new uint[72];
                    fixed (uint* r = row)
                        PixelRow.ToBgra(image, 1, from, to, r);
                    for (int i = 0; i < row.Length; i++)
                        Assert.That(row[i], Is.EqualTo(i < to - from ? source[from + i] | 0xFF000000u : 0));
                }
            }
        }

        /// <summary>Per channel the largest of the pixels that fall into the block.</summary>
        private static uint Reference(Image image, int x, int y, int factor)
        {
            uint blue = 0, green = 0, red = 0;
            var row = new uint[image.Width];
            for (int sy = y * factor; sy < Math.Min(image.Height, (y + 1) * factor); sy++)
            {
                fixed (uint* r = row)
                    PixelRow.ToBgra(image, sy, 0, image.Width, r);
                for (int sx = x * factor; sx < Math.Min(image.Width, (x + 1) * factor); sx++)
                {
                    blue = Math.Max(blue, row[sx] & 255);
                    green = Math.Max(green, row[sx] >> 8 & 255);
                    red = Math.Max(red, row[sx] >> 16 & 255);
                }
            }

            return blue | green << 8 | red << 16;
        }
    }
}
