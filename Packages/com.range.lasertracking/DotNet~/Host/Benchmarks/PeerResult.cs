using System.Collections.Generic;
using Newtonsoft.Json;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>One time of the OpenCV peer, and how many times as long it takes as ours.</summary>
    internal sealed record PeerResult(
        [property: JsonProperty("name")] string Name,
        [property: JsonProperty("variant")] string Variant,
        [property: JsonProperty("iterations")] int Iterations,
        [property: JsonProperty("median_ms")] double MedianMs,
        [property: JsonProperty("p95_ms")] double P95Ms,
        [property: JsonProperty("found_per_frame")] double FoundPerFrame,
        [property: JsonProperty("compare")] IReadOnlyList<string> Compare)
    {
        /// <summary>Peer through ours, by the name of ours.</summary>
        [JsonProperty("ratio")]
        public Dictionary<string, double> Ratio { get; } = new();
    }
}
