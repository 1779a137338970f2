using System;
using LaserTracking.Session;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// The default rule, "scores from confidence and distance" made definite: score = points × certainty × difficulty.
    /// Certainty runs linearly from LeastCertainty at confidence 0 to 1 at FullConfidence and above, so that an ordinary shot loses
    /// nothing and a doubtful one at most half. Difficulty is 1 up to NearDistanceM and grows by DifficultyPerM for each metre
    /// beyond, up to MostDifficulty. Penalties (points of zero or below) count in full at any confidence and distance: a dim laser
    /// must not make hitting a no-shoot cheaper. Immutable.
    /// </summary>
    public sealed class ZoneScoringRule : IScoringRule
    {
        /// <param name="fullConfidence">Confidence from which a hit counts in full; above 0, at most 1.</param>
        /// <param name="leastCertainty">Share that counts at confidence 0; 0…1.</param>
        /// <param name="nearDistanceM">Distance up to which nothing is added; at least 0.</param>
        /// <param name="difficultyPerM">Added for each metre beyond; at least 0, and 0 switches the distance off.</param>
        /// <param name="mostDifficulty">Upper bound of the factor; at least 1.</param>
        public ZoneScoringRule(double fullConfidence = 0.6, double leastCertainty = 0.5, double nearDistanceM = 5, double difficultyPerM = 0.02,
            double mostDifficulty = 1.5)
        {
            if (!(fullConfidence > 0 && fullConfidence <= 1))
                throw new ArgumentException("fullConfidence lies above 0 and at most at 1");
            if (!(leastCertainty >= 0 && leastCertainty <= 1))
                throw new ArgumentException("leastCertainty lies between 0 and 1");
            if (!(nearDistanceM >= 0) || !(difficultyPerM >= 0) || !(mostDifficulty >= 1))
                throw new ArgumentException("nearDistanceM and difficultyPerM are at least 0, mostDifficulty at least 1");
            FullConfidence = fullConfidence;
            LeastCertainty = leastCertainty;
            NearDistanceM = nearDistanceM;
            DifficultyPerM = difficultyPerM;
            MostDifficulty = mostDifficulty;
        }

        public double FullConfidence { get; }

        public double LeastCertainty { get; }

        public double NearDistanceM { get; }

        public double DifficultyPerM { get; }

        public double MostDifficulty { get; }

        /// <inheritdoc/>
        public double Score(in ScoredHit hit, TargetDefinition target, double confidence)
        {
            if (hit.Points <= 0)
                return hit.Points;
            double share = confidence > 0 ? Math.Min(1, confidence / FullConfidence) : 0;
            double certainty = LeastCertainty + (1 - LeastCertainty) * share;
            double difficulty = Math.Min(MostDifficulty, 1 + DifficultyPerM * Math.Max(0, hit.DistanceM - NearDistanceM));
            return hit.Points * certainty * difficulty;
        }
    }
}
