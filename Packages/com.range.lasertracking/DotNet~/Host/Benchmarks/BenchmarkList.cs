using System.Collections.Generic;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>All benchmarks by the names that others rely on.</summary>
    internal static class BenchmarkList
    {
        public static IReadOnlyList<Benchmark> All { get; } = new List<Benchmark>();
    }
}
