using System;

namespace LaserTracking.Detection
{
    /// <summary>How much of a flash the exposures see that it happens to meet: it begins at any moment of a frame interval.</summary>
    internal static class FlashTiming
    {
        private const int Phases = 64;

        /// <summary>Mean over all moments of the best frame's chance.</summary>
        /// <param name="pulseUs">Length of the flash.</param>
        /// <param name="exposureUs">Exposure, at most the interval.</param>
        /// <param name="intervalUs">From frame to frame.</param>
        /// <param name="chance">Of being taken, by the share of a whole exposure that was lit, 0…1.</param>
        public static double Caught(double pulseUs, double exposureUs, double intervalUs, Func<double, double> chance)
        {
            double sum = 0;
            for (int phase = 0; phase < Phases; phase++)
            {
                double begin = (phase + 0.5) / Phases * intervalUs, best = 0;
                for (int frame = 0; frame * intervalUs < begin + pulseUs; frame++)
                {
                    double open = frame * intervalUs;
                    double lit = Math.Min(begin + pulseUs, open + exposureUs) - Math.Max(begin, open);
                    if (lit > best)
                        best = lit;
                    if (best >= exposureUs)
                        break;
                }

                sum += best > 0 ? chance(Math.Min(1, best / exposureUs)) : 0;
            }

            return sum / Phases;
        }

        /// <summary>Share of flashes that fall between two exposures.</summary>
        public static double Missed(double pulseUs, double exposureUs, double intervalUs) =>
            Math.Max(0, intervalUs - exposureUs - pulseUs) / intervalUs;
    }
}
