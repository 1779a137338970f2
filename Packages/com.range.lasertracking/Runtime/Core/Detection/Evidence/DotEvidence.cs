using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// How much speaks for a candidate being the first light of a laser dot: log-odds, the sum of what each measured quantity says
    /// (a generalised additive logistic model). No single quantity decides: a strong round dot may lie where much moves, a faint one
    /// must be alone. Immutable.
    /// </summary>
    public sealed class DotEvidence
    {
        /// <summary>Number of features: of <see cref="DotFeature"/>.</summary>
        public const int Count = (int)DotFeature.Asymmetry + 1;

        /// <summary>What no measure says of most dots at their best, log-odds: that one does not outshine the picture is no reason.</summary>
        private const float OftenAtBest = 1.6f;

        private readonly EvidenceCurve[] _curves;

        /// <param name="baseLogOdds">Log-odds before anything is measured.</param>
        /// <param name="curves">One for each <see cref="DotFeature"/>, in their order. Kept.</param>
        /// <exception cref="ArgumentException">Their number is another one.</exception>
        public DotEvidence(double baseLogOdds, EvidenceCurve[] curves)
        {
            if (curves.Length != Count)
                throw new ArgumentException("one curve is needed for each feature", nameof(curves));
            Base = baseLogOdds;
            _curves = curves;
        }

        /// <summary>What the detector was built with.</summary>
        public static DotEvidence Learned { get; } = new DotEvidence(DotEvidenceCurves.Base, DotEvidenceCurves.All);

        public ReadOnlySpan<EvidenceCurve> Curves => _curves;

        /// <summary>Log-odds before anything is measured.</summary>
        public double Base { get; }

        /// <summary>The sum over all features.</summary>
        public double LogOdds(ReadOnlySpan<float> features)
        {
            double sum = Base;
            for (int i = 0; i < features.Length; i++)
                sum += _curves[i].At(features[i]);
            return sum;
        }

        /// <summary>The sum if everything around the candidate, which takes long to measure, spoke for it as much as it ever can.</summary>
        public double HighestLogOdds(ReadOnlySpan<float> features)
        {
            double sum = Base;
            for (int i = 0; i < features.Length; i++)
                sum += IsOfSurroundings(i) ? _curves[i].Highest : _curves[i].At(features[i]);
            return sum;
        }

        /// <summary>The feature that speaks most against a dot.</summary>
        /// <param name="features">One value for each.</param>
        /// <param name="withSurroundings">False: only those of the candidate itself.</param>
        public int StrongestAgainst(ReadOnlySpan<float> features, bool withSurroundings)
        {
            int strongest = 0;
            float lowest = float.PositiveInfinity;
            for (int i = 0; i < features.Length; i++)
            {
                if (!withSurroundings && IsOfSurroundings(i))
                    continue;

                // What a feature could say at best is the yardstick: one that never says much for a dot is no reason.
                float loss = _curves[i].At(features[i]) - Math.Min(_curves[i].Highest, OftenAtBest);
                if (loss >= lowest)
                    continue;
                lowest = loss;
                strongest = i;
            }

            return strongest;
        }

        private static bool IsOfSurroundings(int feature)
        {
            switch ((DotFeature)feature)
            {
                case DotFeature.RingShare:
                case DotFeature.BrightenedAround:
                case DotFeature.DarkenedAround:
                case DotFeature.DarkenedRing:
                case DotFeature.ContrastNow:
                case DotFeature.ContrastBefore:
                case DotFeature.RisenAround:
                case DotFeature.Asymmetry:
                    return true;
                default:
                    return false;
            }
        }
    }
}
