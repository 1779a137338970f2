using System;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>The gathering of a depth picture into cells, in whichever form the processor has, against plain arithmetic.</summary>
    public sealed unsafe class DepthGridKernelTests
    {
        [Test]
        public void Row_OfCells_IsTheMeanOfWhatLiesOnTheNearestSurface([Values(1, 2, 4, 7)] int step, [Values(1, 7, 8, 9, 16, 17, 41)] int cells)
        {
            const int Near = 500, Far = 4000, SurfaceStep = 50;
            int first = step >= 4 ? step / 4 : 0, second = step >= 4 ? step - 1 - step / 4 : step - 1;
            var random = new Random(100 * step + cells);
            ushort[] top = Row(random, cells * step), bottom = Row(random, cells * step);
            float[] z = new float[cells], expected = new float[cells];
            bool[] lost = new bool[cells], expectedLost = new bool[cells];
            for (int cell = 0; cell < cells; cell++)
            {
                int[] pixels = { top[cell * step + first], top[cell * step + second], bottom[cell * step + first], bottom[cell * step + second] };
                expectedLost[cell] = Array.TrueForAll(pixels, pixel => pixel == 0);
                int[] seen = Array.FindAll(pixels, pixel => pixel >= Near);
                Array.Sort(seen);
                if (seen.Length == 0 || seen[0] > Far)
                    continue;
                int[] surface = Array.FindAll(seen, pixel => pixel <= seen[0] + SurfaceStep);
                int sum = 0;
                foreach (int pixel in surface)
                    sum += pixel;
                expected[cell] = sum / (float)surface.Length;
            }

            fixed (ushort* t = top, b = bottom)
            fixed (float* to = z)
            fixed (bool* l = lost)
                DepthGridKernel.Row(t, b, cells, step, first, second, Near, Far, SurfaceStep, to, l);
            Assert.That(z, Is.EqualTo(expected));
            Assert.That(lost, Is.EqualTo(expectedLost));
        }

        /// <summary>Lost, too near, on one of two surfaces or too far.</summary>
        private static ushort[] Row(Random random, int pixels)
        {
            var row = new ushort[pixels];
            for (int x = 0; x < pixels; x++)
            {
                int kind = random.Next(8);
                row[x] = (ushort)(kind < 2 ? 0 : kind == 2 ? random.Next(1, 520) : kind == 3 ? random.Next(3980, 65536) : random.Next(2) * 300 + random.Next(1000, 1070));
            }

            return row;
        }
    }
}
