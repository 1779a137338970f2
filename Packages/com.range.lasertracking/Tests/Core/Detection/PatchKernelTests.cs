using System;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>What the shake meter reads and compares, in whichever form the processor has, against plain arithmetic.</summary>
    public sealed unsafe class PatchKernelTests
    {
        private const int Window = PatchKernel.Window, Size = PatchKernel.Size;

        [TestCase(PixelFormat.Bgra32, 1)]
        [TestCase(PixelFormat.Bgra32, 2)]
        [TestCase(PixelFormat.Nv12, 1)]
        [TestCase(PixelFormat.Nv12, 2)]
        [TestCase(PixelFormat.Yuy2, 1)]
        [TestCase(PixelFormat.Yuy2, 2)]
        [TestCase(PixelFormat.Gray8, 2)]
        public void Read_Patch_IsGreenOrLumaAndTheMeanOfTwo(PixelFormat format, int factor)
        {
            const int Left = 9, Top = 6;
            var random = new Random(21);
            using (var image = new Image())
            {
                image.Reset(format, factor * (Window + 2 * Left), factor * (Window + Top), 0);
                random.NextBytes(image.Bytes);
                int bytes = format == PixelFormat.Bgra32 ? 4 : format == PixelFormat.Yuy2 ? 2 : 1, green = bytes == 4 ? 1 : 0;
                var patch = new byte[PatchBands.Area];
                fixed (byte* to = patch)
                    PatchKernel.Read(image, Left, Top, factor, to);
                for (int i = 0; i < patch.Length; i++)
                {
                    byte* pixel = image.Pixels + (Top + i / Window) * factor * image.Stride + (Left + i % Window) * factor * bytes + green;
                    Assert.That(patch[i], Is.EqualTo(factor == 1 ? *pixel : (*pixel + pixel[bytes] + 1) / 2), "at " + i);
                }
            }
        }

        [Test]
        public void SumUp_Patch_SumsTheMiddleOfEachColumnAndRow()
        {
            var patch = new byte[PatchBands.Area];
            new Random(22).NextBytes(patch);
            int[] columns = new int[Window], rows = new int[Window], expectedColumns = new int[Window], expectedRows = new int[Window];
            for (int i = 0; i < patch.Length; i++)
            {
                int x = i % Window, y = i / Window;
                if (x >= PatchKernel.Reach && x < PatchKernel.Reach + Size)
                    expectedRows[y] += patch[i];
                if (y >= PatchKernel.Reach && y < PatchKernel.Reach + Size)
                    expectedColumns[x] += patch[i];
            }

            fixed (byte* p = patch)
            fixed (int* c = columns, r = rows)
                PatchKernel.SumUp(p, c, r);
            Assert.That(columns, Is.EqualTo(expectedColumns));
            Assert.That(rows, Is.EqualTo(expectedRows));
        }

        [Test]
        public void Compare_Slopes_AreSummedUpInOrder()
        {
            var random = new Random(23);
            double[] slopes = new double[PatchKernel.Slopes + 1], expected = new double[Size], differences = new double[PatchKernel.Shifts + 1];
            for (int i = 0; i < slopes.Length; i++)
                slopes[i] = random.Next(-8000, 8000);
            for (int i = 0; i < Size; i++)
                expected[i] = 16000 * (random.NextDouble() - 0.5);
            fixed (double* s = slopes, e = expected, d = differences)
                PatchKernel.Compare(s, e, d);
            for (int shift = 0; shift < PatchKernel.Shifts; shift++)
            {
                double sum = 0;
                for (int i = 0; i < Size; i++)
                    sum += Math.Abs(slopes[shift + i] - expected[i]);
                Assert.That(differences[shift], Is.EqualTo(sum), "shift " + shift);
            }
        }
    }
}
