using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Brightness against that of a frame ago, in whichever form the processor has, against plain arithmetic.</summary>
    public sealed unsafe class RatioBandsTests
    {
        [Test]
        public void Count_EveryPairOfLevels_IsTheWholePartOfTheQuotient()
        {
            // Every third byte counts: all pairs of levels, and a few more that fill no block.
            var now = new byte[3 * 65536 + 20];
            var before = new byte[now.Length];
            for (int i = 0; i < now.Length; i++)
            {
                now[i] = (byte)(i / 3);
                before[i] = (byte)(i / 3 >> 8);
            }

            var expected = new int[256];
            for (int i = 0; i < now.Length; i += 3)
            {
                if (before[i] >= 24 && before[i] <= 245 && now[i] <= 245)
                    expected[Math.Min(255, (64 * now[i] + before[i] / 2) / before[i])]++;
            }

            Assert.That(Run(now, before, -1, 0, out long[] _), Is.EqualTo(expected));
        }

        [TestCase(64, 5)]
        [TestCase(21, 3)]
        [TestCase(255, 14)]
        public void SumUp_RandomLevels_TakesThoseNearTheMiddle(int middle, int width)
        {
            var random = new Random(middle);
            foreach (int length in new[] { 1, 47, 48, 49, 97, 5000 })
            {
                byte[] now = new byte[length], before = new byte[length];
                random.NextBytes(before);
                for (int i = 0; i < length; i++)
                    now[i] = random.Next(4) == 0 ? (byte)random.Next(256) : (byte)Math.Min(255, before[i] * middle / 64 + random.Next(-3, 4) & 255);
                var expected = new long[3];
                for (int i = 0; i < length; i += 3)
                {
                    if (before[i] < 24 || before[i] > 245 || now[i] > 245 || Math.Abs(64 * now[i] - middle * before[i]) > width * before[i])
                        continue;
                    expected[0]++;
                    expected[1] += now[i];
                    expected[2] += before[i];
                }

                Run(now, before, middle, width, out long[] sums);
                Assert.That(sums, Is.EqualTo(expected), "length " + length);
            }
        }

        private static int[] Run(byte[] now, byte[] before, int middle, int width, out long[] sums)
        {
            var ratios = new int[256];
            var reciprocals = new ulong[256];
            for (int i = 1; i < 256; i++)
                reciprocals[i] = ((1UL << 32) + (ulong)i - 1) / (ulong)i;
            sums = new long[3];
            fixed (byte* n = now, b = before)
            fixed (ulong* reciprocal = reciprocals)
            fixed (int* r = ratios)
            fixed (long* s = sums)
            {
                var work = new RatioBands { Now = n, Before = b, Length = now.Length, BandCount = 1, Middle = middle, Width = width, Reciprocals = reciprocal, Ratios = r, Sums = s };
                work.Execute(0);
            }

            return ratios;
        }
    }
}
