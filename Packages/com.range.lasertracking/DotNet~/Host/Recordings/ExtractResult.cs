using System;

namespace LaserTracking.Host.Recordings
{
    /// <summary>What `extract` wrote.</summary>
    /// <param name="Captures">Number of captures.</param>
    /// <param name="Payloads">Number of lines in frames.jsonl.</param>
    /// <param name="Bytes">Sum of the payload sizes.</param>
    /// <param name="WasCancelled">The work was interrupted; what is listed in frames.jsonl is whole.</param>
    internal readonly record struct ExtractResult(long Captures, long Payloads, long Bytes, bool WasCancelled)
    {
        /// <summary>One line for people.</summary>
        public override string ToString() =>
            FormattableString.Invariant($"{Captures} captures, {Payloads} payloads, {Bytes} bytes{(WasCancelled ? ", interrupted" : "")}");
    }
}
