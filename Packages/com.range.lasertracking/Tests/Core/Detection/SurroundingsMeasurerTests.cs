using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed unsafe class SurroundingsMeasurerTests
    {
        /// <summary>In whichever form the processor has, to the bit: sums of rounded numbers depend on their order.</summary>
        [TestCase(1)]
        [TestCase(2)]
        [TestCase(37)]
        public void AddRises_OfARow_AreSummedUpInOrder(int count)
        {
            var random = new Random(count);
            uint[] now = new uint[count], before = new uint[count];
            var table = new double[256];
            double[] rises = { 0.1, 0.2, 0.3, 0.4 }, expected = (double[])rises.Clone();
            int[] levels = new int[4], expectedLevels = new int[3];
            for (int i = 0; i < table.Length; i++)
                table[i] = random.NextDouble();
            for (int i = 0; i < count; i++)
            {
                now[i] = (uint)random.Next() * 2u;
                before[i] = (uint)random.Next() * 2u;
                var shares = new double[3];
                for (int channel = 0; channel < 3; channel++)
                {
                    int here = (int)(now[i] >> 8 * channel & 255), past = (int)(before[i] >> 8 * channel & 255);
                    shares[channel] = (here - past) * table[Math.Min(here, past)];
                    expected[channel] += shares[channel];
                    expectedLevels[channel] += past;
                }

                expected[3] += Math.Abs(shares[1] - shares[2]);
            }

            fixed (uint* n = now, b = before)
            fixed (double* t = table, r = rises)
            fixed (int* l = levels)
                SurroundingsMeasurer.AddRises(n, b, count, t, r, l);
            Assert.That(rises, Is.EqualTo(expected));
            Assert.That(new[] { levels[0], levels[1], levels[2] }, Is.EqualTo(expectedLevels));
        }
    }
}
