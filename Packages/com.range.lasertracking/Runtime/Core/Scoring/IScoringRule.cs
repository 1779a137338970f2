using LaserTracking.Session;

namespace LaserTracking.Scoring
{
    /// <summary>Turns a zone's points into a score. Replace it to score another discipline; must be pure and allocate nothing.</summary>
    public interface IScoringRule
    {
        /// <param name="hit">Complete but for its score.</param>
        /// <param name="target">What was hit.</param>
        /// <param name="confidence">The shot's, 0…1.</param>
        double Score(in ScoredHit hit, TargetDefinition target, double confidence);
    }
}
