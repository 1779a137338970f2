using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// How much speaks for a candidate being the first light of a laser dot: log-odds, the sum of what each measured quantity says
    /// (a generalised additive logistic model). No single quantity decides: a strong round dot may lie where much moves, a faint one
    /// must be alone.
    /// </summary>
    internal static class DotEvidence
    {
        public static int Count => DotEvidenceCurves.All.Length;

        public static ReadOnlySpan<EvidenceCurve> Curves => DotEvidenceCurves.All;

        /// <summary>Log-odds before anything is measured.</summary>
        public static double Base => DotEvidenceCurves.Base;

        /// <summary>The sum over all features.</summary>
        public static double LogOdds(ReadOnlySpan<float> features)
        {
            double sum = DotEvidenceCurves.Base;
            for (int i = 0; i < features.Length; i++)
                sum += DotEvidenceCurves.All[i].At(features[i]);
            return sum;
        }

        /// <summary>The sum if everything around the candidate, which takes long to measure, spoke for it as much as it ever can.</summary>
        public static double HighestLogOdds(ReadOnlySpan<float> features)
        {
            double sum = DotEvidenceCurves.Base;
            for (int i = 0; i < features.Length; i++)
                sum += IsOfSurroundings(i) ? DotEvidenceCurves.All[i].Highest : DotEvidenceCurves.All[i].At(features[i]);
            return sum;
        }

        /// <summary>The feature that speaks most against a dot.</summary>
        /// <param name="features">One value for each.</param>
        /// <param name="withSurroundings">False: only those of the candidate itself.</param>
        public static int StrongestAgainst(ReadOnlySpan<float> features, bool withSurroundings)
        {
            int strongest = 0;
            float lowest = float.PositiveInfinity;
            for (int i = 0; i < features.Length; i++)
            {
                if (!withSurroundings && IsOfSurroundings(i))
                    continue;

                // What a feature could say at best is the yardstick: one that never says much for a dot is no reason.
                float loss = DotEvidenceCurves.All[i].At(features[i]) - DotEvidenceCurves.All[i].Highest;
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
                    return true;
                default:
                    return false;
            }
        }
    }
}
