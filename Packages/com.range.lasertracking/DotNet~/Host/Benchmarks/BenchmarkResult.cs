using Newtonsoft.Json;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>One line of bench --json.</summary>
    internal sealed record BenchmarkResult(
        [property: JsonProperty("name")] string Name,
        [property: JsonProperty("what")] string What,
        [property: JsonProperty("iterations")] int Iterations,
        [property: JsonProperty("median_ms")] double MedianMs,
        [property: JsonProperty("p95_ms")] double P95Ms,
        [property: JsonProperty("alloc_bytes_per_op")] long AllocatedBytesPerOperation);
}
