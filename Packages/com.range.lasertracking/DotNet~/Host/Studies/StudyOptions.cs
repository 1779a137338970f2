using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Studies
{
    /// <summary>What the user asked for.</summary>
    /// <param name="FirstSeed">First of the seeds to run.</param>
    /// <param name="LastSeed">The last one, included.</param>
    /// <param name="Progress">Where to say how far it is.</param>
    /// <param name="Only">Run only the cases whose names contain one of these, separated by commas; null: all.</param>
    internal sealed record StudyOptions(int FirstSeed, int LastSeed, ProgressLine Progress, string? Only = null)
    {
        public bool Includes(string caseName) => Only == null || System.Linq.Enumerable.Any(Only.Split(',', System.StringSplitOptions.RemoveEmptyEntries | System.StringSplitOptions.TrimEntries), part => caseName.Contains(part, System.StringComparison.OrdinalIgnoreCase));
    }
}
