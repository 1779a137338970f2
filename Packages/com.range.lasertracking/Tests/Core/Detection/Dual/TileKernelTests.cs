using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed unsafe class TileKernelTests
    {
        [TestCase(1, 1)]
        [TestCase(7, 3)]
        [TestCase(8, 8)]
        [TestCase(65, 8)]
        [TestCase(1023, 5)]
        public void Brightest_VectorAndScalar_AreEqual(int width, int rows)
        {
            var random = new System.Random(width);
            int stride = width + 3;
            var pixels = new ushort[stride * rows];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = (ushort)random.Next(65536);
            var scalar = new ushort[TileKernel.Count(width)];
            var vector = new ushort[scalar.Length];
            fixed (ushort* p = pixels, s = scalar, v = vector)
            {
                TileKernel.Brightest((byte*)p, stride * 2, rows, width, s, false);
                TileKernel.Brightest((byte*)p, stride * 2, rows, width, v, true);
            }

            Assert.That(vector, Is.EqualTo(scalar));
            Assert.That(scalar[0], Is.GreaterThan(0));
        }

        [TestCase(1, 1)]
        [TestCase(7, 3)]
        [TestCase(8, 8)]
        [TestCase(65, 8)]
        [TestCase(1023, 5)]
        public void Greenest_VectorAndScalar_AreEqual(int width, int rows)
        {
            var random = new System.Random(width + 1);
            int stride = width + 3;
            var pixels = new uint[stride * rows];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = (uint)random.Next() * 2 + (uint)random.Next(2);
            var scalar = new byte[TileKernel.Count(width)];
            var vector = new byte[scalar.Length];
            fixed (uint* p = pixels)
            fixed (byte* s = scalar, v = vector)
            {
                TileKernel.Greenest((byte*)p, stride * 4, rows, width, s, false);
                TileKernel.Greenest((byte*)p, stride * 4, rows, width, v, true);
            }

            Assert.That(vector, Is.EqualTo(scalar));
        }
    }
}
