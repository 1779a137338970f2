namespace LaserTracking.Host.Recordings
{
    /// <summary>What `extract` is to write.</summary>
    internal sealed class ExtractOptions
    {
        /// <summary>Folder of the result; made when it is not there.</summary>
        public required string OutputFolder { get; init; }

        /// <summary>First capture, 0-based.</summary>
        public int FirstCapture { get; init; }

        /// <summary>Last capture, included.</summary>
        public int LastCapture { get; init; } = int.MaxValue;

        /// <summary>Only frames.jsonl, no payload files.</summary>
        public bool HashesOnly { get; init; }

        /// <summary>Not all captures were asked for.</summary>
        public bool HasRange => FirstCapture > 0 || LastCapture < int.MaxValue;
    }
}
