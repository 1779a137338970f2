using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What becomes of a flash over the frames that it happens to meet; it begins at any moment of a frame interval. One conclusive frame
    /// suffices. What is taken without being conclusive has to be taken again in every frame in which it still shines, and then to
    /// vanish. A lit frame in which it is not taken is learned as background: only what exceeds it counts in the next.
    /// </summary>
    internal static class FlashTiming
    {
        private const int Phases = 48;

        /// <summary>Less rise than this share of the first frame's is no trace: it counts as gone.</summary>
        private const double TraceShare = 0.5;

        /// <summary>Mean over all moments of the probability that the flash is caught.</summary>
        /// <param name="pulseUs">Length of the flash.</param>
        /// <param name="exposureUs">Exposure, at most the interval.</param>
        /// <param name="intervalUs">From frame to frame.</param>
        /// <param name="maxWaitFrames">Frames that what is not conclusive may last.</param>
        /// <param name="taken">Probability that a frame takes it, by the share of a whole exposure that was lit, 0…1.</param>
        /// <param name="conclusive">The same for being conclusive in that frame.</param>
        /// <param name="rise">What that share raises the picture by; and back, the share for a rise given as a negative number.</param>
        public static double Caught(double pulseUs, double exposureUs, double intervalUs, int maxWaitFrames, Func<double, double> taken, Func<double, double> conclusive,
            Func<double, double> rise)
        {
            double sum = 0;
            for (int phase = 0; phase < Phases; phase++)
                sum += Caught((phase + 0.5) / Phases * intervalUs, pulseUs, exposureUs, intervalUs, maxWaitFrames, taken, conclusive, rise);
            return sum / Phases;
        }

        /// <summary>Share of flashes that fall between two exposures.</summary>
        public static double Missed(double pulseUs, double exposureUs, double intervalUs) =>
            Math.Max(0, intervalUs - exposureUs - pulseUs) / intervalUs;

        private static double Caught(double beginUs, double pulseUs, double exposureUs, double intervalUs, int maxWaitFrames, Func<double, double> taken, Func<double, double> conclusive, Func<double, double> rise)
        {
            // Probabilities: unseen so far, waiting since the frame with the light firstLit, caught.
            double unseen = 1, waiting = 0, caught = 0, firstLit = 0, last = 0;
            int waited = 0;
            for (int frame = 0; frame * intervalUs < beginUs + pulseUs; frame++)
            {
                double open = frame * intervalUs;
                double lit = (Math.Min(beginUs + pulseUs, open + exposureUs) - Math.Max(beginUs, open)) / exposureUs;
                if (lit <= 0)
                    continue;
                lit = Math.Min(1, lit);
                if (rise(lit) < TraceShare * rise(firstLit))
                {
                    caught += waiting;
                    waiting = 0;
                }

                waiting *= ++waited > maxWaitFrames ? 0 : taken(lit);
                double more = rise(lit) - rise(last), fresh = more <= 0 ? 0 : last <= 0 ? lit : rise(-more), onset = fresh <= 0 ? 0 : taken(fresh), sure = fresh <= 0 ? 0 : Math.Min(onset, conclusive(fresh));
                caught += unseen * sure;
                if (unseen * (onset - sure) > waiting)
                {
                    firstLit = lit;
                    waited = 0;
                }

                waiting += unseen * (onset - sure);
                unseen *= 1 - onset;
                last = lit;
                if (unseen + waiting < 1e-4)
                    break;
            }

            return caught + waiting;
        }
    }
}
