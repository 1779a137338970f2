using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Brightness of samples through that of the same ones a frame ago: first how often each ratio occurs, then, near the commonest,
    /// the sums. A band is a share of the samples; what bands count is added up afterwards, in whole numbers.
    /// </summary>
    internal unsafe partial struct RatioBands : IKernelBands
    {
        private const int SampleStep = 3, DarkestForRatio = 24, BrightestForRatio = 245;

        public byte* Now;
        public byte* Before;
        public int Length;
        public int BandCount;

        /// <summary>Ratio, in sixty-fourths, near which samples are summed up; below 0: ratios are counted.</summary>
        public int Middle;

        /// <summary>How far from it.</summary>
        public int Width;

        /// <summary>2^32 / i, rounded up: a product's upper half is the exact quotient of what is far below 2^32.</summary>
        public ulong* Reciprocals;

        /// <summary>256 for each band.</summary>
        public int* Ratios;

        /// <summary>For each band: samples near the middle, their brightness now, and before.</summary>
        public long* Sums;

        public void Execute(int band)
        {
            int samples = (Length + SampleStep - 1) / SampleStep;
            int first = SampleStep * (int)((long)samples * band / BandCount), end = SampleStep * (int)((long)samples * (band + 1) / BandCount);
            if (end > Length)
                end = Length;
            if (Middle < 0)
                Count(first, end, Ratios + 256 * band);
            else
                SumUp(first, end, Sums + 3 * band);
        }

        private static bool IsUsable(int now, int before) => before >= DarkestForRatio && before <= BrightestForRatio && now <= BrightestForRatio;

        private void Count(int first, int end, int* ratios)
        {
            byte* here = Now, past = Before;
            ulong* reciprocals = Reciprocals;
            for (int i = 0; i < 256; i++)
                ratios[i] = 0;
            int left = first;
#if NET8_0_OR_GREATER
            left = CountVector(here, past, first, end, ratios);
#endif
            for (int i = left; i < end; i += SampleStep)
            {
                int now = here[i], before = past[i];
                if (!IsUsable(now, before))
                    continue;
                int ratio = (int)((ulong)(64 * now + before / 2) * reciprocals[before] >> 32);
                ratios[ratio < 255 ? ratio : 255]++;
            }
        }

        private void SumUp(int first, int end, long* sums)
        {
            byte* here = Now, past = Before;
            int count = 0, sumNow = 0, sumBefore = 0, middle = Middle, width = Width, left = first;
#if NET8_0_OR_GREATER
            left = SumUpVector(here, past, first, end, middle, width, ref count, ref sumNow, ref sumBefore);
#endif
            for (int i = left; i < end; i += SampleStep)
            {
                // What is outside one of the limits makes the sign: a branch would be guessed wrongly every few samples.
                int now = here[i], before = past[i], off = 64 * now - middle * before, near = width * before;
                int within = ~(before - DarkestForRatio | BrightestForRatio - before | BrightestForRatio - now | near - off | near + off) >> 31;
                count -= within;
                sumNow += now & within;
                sumBefore += before & within;
            }

            sums[0] = count;
            sums[1] = sumNow;
            sums[2] = sumBefore;
        }
    }
}
