using System.Collections.Generic;

namespace LaserTracking.Session
{
    /// <summary>What a session ran on: the "header" line of events.jsonl.</summary>
    public sealed class SessionHeader
    {
        public SessionHeader(string version, IReadOnlyList<SessionInput> inputs, string? calibration, string detector, long? seed)
        {
            Version = version;
            Inputs = inputs;
            Calibration = calibration;
            Detector = detector;
            Seed = seed;
        }

        /// <summary>Version of the package.</summary>
        public string Version { get; }

        public IReadOnlyList<SessionInput> Inputs { get; }

        /// <summary>Path of the calibration, or null.</summary>
        public string? Calibration { get; }

        public string Detector { get; }

        /// <summary>Of a simulation; null otherwise.</summary>
        public long? Seed { get; }
    }
}
