using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed unsafe class DelayMeterTests
    {
        [Test]
        public void AddWeighed_TwoPictures_AreSummedByTheirShares()
        {
            var random = new Random(3);
            var first = new short[ScreenGrid.CellCount];
            var second = new short[ScreenGrid.CellCount];
            for (int i = 0; i < first.Length; i++)
            {
                first[i] = (short)random.Next(9181);
                second[i] = (short)random.Next(9181);
            }

            var sums = new int[ScreenGrid.CellCount];
            fixed (short* a = first, b = second)
            fixed (int* s = sums)
            {
                DelayMeter.AddWeighed(a, 200, s);
                DelayMeter.AddWeighed(b, 56, s);
            }

            for (int i = 0; i < sums.Length; i++)
                Assert.That(sums[i], Is.EqualTo(200 * first[i] + 56 * second[i]));
        }
    }
}
