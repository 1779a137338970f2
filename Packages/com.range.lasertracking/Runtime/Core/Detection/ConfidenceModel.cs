using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// How sure it is that a dot is a laser. Each published factor brings log-odds; together they give a probability (logistic
    /// regression on dots at first sight: simulated ranges and recorded clips, usual and wide limits, see ./range study confidence).
    /// The probability is then shared out so that every factor keeps to its published range and their sum is the probability.
    /// </summary>
    internal static class ConfidenceModel
    {
        private const double PeakWeight = 0.4, ContrastWeight = 0.3, CenterWeight = 0.2, StabilityWeight = 0.1;

        /// <summary>No sum of evidence counts for more: one dot in four hundred surprises.</summary>
        private const double MostLogOdds = 6;

        /// <summary>Of the regression, with each factor centred as below.</summary>
        private const double Bias = 3.4;

        /// <summary>What is conclusive by other means than the curves (light above the picture, or where none was expected) counts as this much evidence.</summary>
        private const double ConclusiveEvidence = 4;

        /// <param name="c">The candidate, judged.</param>
        /// <param name="awayShare">Distance from the picture's centre through that of its corners, 0…1.</param>
        public static ConfidenceFactors Of(in Candidate c, double awayShare)
        {
            // How high it rose; how it stands out, in colour and against its ring; where it is; what all measures together say, and how still its surroundings are.
            double evidence = c.IsConclusive ? Math.Max(c.LogOdds, ConclusiveEvidence) : c.LogOdds;
            double peak = 5.4 * (c.PeakRelativeRise / 255.0 - 0.8);
            double contrast = 3.9 * (Math.Abs(c.GreenCoherence) - 0.7) - 2.2 * Math.Min(0.6, c.RingLevel);
            double center = 0.45 - Math.Min(1, awayShare);
            double stability = 1.28 * Math.Max(-4, Math.Min(8, evidence)) - 12 * Math.Min(0.4, c.MotionShare);
            return Share(Bias + peak + contrast + center + stability, peak, contrast, center, stability);
        }

        /// <summary>The same dot with this much more evidence for it, log-odds.</summary>
        public static ConfidenceFactors Raise(in ConfidenceFactors f, double logOdds)
        {
            double peak = LogOdds(f.Peak / PeakWeight), contrast = LogOdds(f.Contrast / ContrastWeight);
            return Share(LogOdds(f.Sum) + logOdds, peak, contrast, LogOdds(f.Center / CenterWeight), LogOdds(f.Stability / StabilityWeight));
        }

        /// <summary>Factor = weight / (1 + exp(−shift − evidence)), the shift such that the factors' sum is the probability.</summary>
        private static ConfidenceFactors Share(double logOdds, double peak, double contrast, double center, double stability)
        {
            double probability = Logistic(Math.Max(-MostLogOdds, Math.Min(MostLogOdds, logOdds)));
            ConfidenceFactors factors = default;
            double low = -40, high = 40;
            for (int i = 0; i < 40; i++)
            {
                double shift = (low + high) / 2;
                factors = new ConfidenceFactors(PeakWeight * Logistic(shift + Limit(peak)), ContrastWeight * Logistic(shift + Limit(contrast)),
                    CenterWeight * Logistic(shift + Limit(center)), StabilityWeight * Logistic(shift + Limit(stability)));
                if (factors.Sum < probability)
                    low = shift;
                else
                    high = shift;
            }

            return factors;
        }

        private static double Limit(double evidence) => Math.Max(-MostLogOdds, Math.Min(MostLogOdds, evidence));

        private static double Logistic(double logOdds) => 1 / (1 + Math.Exp(-logOdds));

        private static double LogOdds(double p) => Math.Log(Math.Max(1e-6, p) / Math.Max(1e-6, 1 - p));
    }
}
