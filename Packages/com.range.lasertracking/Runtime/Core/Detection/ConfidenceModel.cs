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

        /// <summary>Bias of the regression with the evidence centred as above: 5.4 · 0.2 + 0.6 · 1.5 + 4 · 0.7 − 3.9 · 0.45 − 0.4.</summary>
        private const double Bias = 2.6;

        /// <param name="c">The candidate, judged.</param>
        /// <param name="awayShare">Distance from the picture's centre through that of its corners, 0…1.</param>
        public static ConfidenceFactors Of(in Candidate c, double awayShare)
        {
            // How high and how vividly it rose; how it stands out, in shape and colour; where it is; how it agrees with its surroundings.
            double peak = 5.4 * (c.PeakRelativeRise / 255.0 - 0.8) + 0.6 * (Math.Min(3, c.Vividness) - 1.5);
            double contrast = 4 * (Math.Abs(c.GreenCoherence) - 0.7) - 58 * Math.Min(0.2, c.RingShare) - 13.7 * Math.Min(0.6, c.RingLevel) + 2 * (c.Compactness - 0.9);
            double center = 3.9 * (0.45 - Math.Min(1, awayShare));
            double elongation = c.ShortSigma > 0 ? c.LongSigma / c.ShortSigma : 1;
            double stability = (c.IsConclusive ? 4.6 : 0) - 14.9 * Math.Min(0.4, c.MotionShare) - Math.Min(3, elongation - 1);
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
