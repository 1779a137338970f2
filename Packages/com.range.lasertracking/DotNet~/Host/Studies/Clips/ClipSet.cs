using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>The recorded clips with hand-verified truth: the folder clips of the reference data, any clips of that layout.</summary>
    internal sealed class ClipSet
    {
        private ClipSet(string folder, IReadOnlyList<TruthClip> clips)
        {
            Folder = folder;
            Clips = clips;
        }

        public string Folder { get; }

        public IReadOnlyList<TruthClip> Clips { get; }

        /// <exception cref="InputException">The reference data are not there.</exception>
        public static ClipSet Open() =>
            TryOpen() ?? throw new InputException(TruthPath(), "the recorded clips are not there", "set RANGE_DATA to the folder that holds clips/truth.json");

        /// <summary>Null when the reference data are not there.</summary>
        public static ClipSet? TryOpen()
        {
            string truth = TruthPath();
            return File.Exists(truth) ? new ClipSet(Path.GetDirectoryName(truth)!, TruthFile.Read(truth)) : null;
        }

        private static string TruthPath()
        {
            string data = Environment.GetEnvironmentVariable("RANGE_DATA") is { Length: > 0 } given
                ? given
                : Path.Combine(RepositoryFolder.Find(), "..", "shared", "data");
            return Path.Combine(data, "clips", "truth.json");
        }

        public string PathOf(TruthClip clip) => Path.Combine(Folder, clip.File);
    }
}
