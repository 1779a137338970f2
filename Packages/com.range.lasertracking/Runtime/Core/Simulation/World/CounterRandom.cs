using System;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Random numbers as a function of what they are for (seed, stream, two counters), so that no order of calls can change them.
    /// The mixing is SplitMix64's finaliser (Steele, Lea, Flood 2014).
    /// </summary>
    internal static class CounterRandom
    {
        public static ulong Hash(int seed, RandomStream stream, long a, long b = 0)
        {
            ulong x = Mix((ulong)seed * 0x9E3779B97F4A7C15UL + (ulong)stream);
            x = Mix(x ^ (ulong)a * 0xD1B54A32D192ED03UL);
            return Mix(x ^ (ulong)b * 0xAEF17502108EF2D9UL);
        }

        /// <summary>0 ≤ value &lt; 1.</summary>
        public static double Uniform(int seed, RandomStream stream, long a, long b = 0) =>
            (Hash(seed, stream, a, b) >> 11) * (1.0 / 9007199254740992.0);

        /// <summary>Mean 0, standard deviation 1 (Box–Muller).</summary>
        public static double Gaussian(int seed, RandomStream stream, long a, long b = 0)
        {
            double u = 1 - Uniform(seed, stream, a, 2 * b), v = Uniform(seed, stream, a, 2 * b + 1);
            return Math.Sqrt(-2 * Math.Log(u)) * Math.Cos(2 * Math.PI * v);
        }

        /// <summary>32 well mixed bits of a pixel under a frame's key; cheap enough for every pixel.</summary>
        public static uint Pixel(uint index, uint key)
        {
            uint x = index * 0x9E3779B1u ^ key;
            x ^= x >> 16;
            x *= 0x7FEB352Du;
            x ^= x >> 15;
            x *= 0x846CA68Bu;
            return x;
        }

        /// <summary>1024 quantiles of the normal distribution, scaled so that their standard deviation is exactly 256.</summary>
        public static short[] GaussianTable()
        {
            const int count = 1024;
            var values = new double[count];
            double sum = 0;
            for (int i = 0; i < count; i++)
            {
                values[i] = Quantile((i + 0.5) / count);
                sum += values[i] * values[i];
            }

            double scale = 256 / Math.Sqrt(sum / count);
            var table = new short[count];
            for (int i = 0; i < count; i++)
                table[i] = (short)Math.Round(values[i] * scale);
            return table;
        }

        private static ulong Mix(ulong x)
        {
            x ^= x >> 30;
            x *= 0xBF58476D1CE4E5B9UL;
            x ^= x >> 27;
            x *= 0x94D049BB133111EBUL;
            return x ^ x >> 31;
        }

        // By bisection of the distribution function: slow, exact enough, and only run once a table.
        private static double Quantile(double p)
        {
            double low = -6, high = 6;
            for (int i = 0; i < 50; i++)
            {
                double middle = (low + high) / 2;
                if (Cumulative(middle) < p)
                    low = middle;
                else
                    high = middle;
            }

            return (low + high) / 2;
        }

        // Marsaglia's series (2004), good to double precision over this range.
        private static double Cumulative(double x)
        {
            double sum = x, term = x, last = 0;
            for (int i = 3; sum != last; i += 2)
            {
                last = sum;
                term *= x * x / i;
                sum += term;
            }

            return 0.5 + sum * Math.Exp(-0.5 * x * x - 0.91893853320467274178);
        }
    }
}
