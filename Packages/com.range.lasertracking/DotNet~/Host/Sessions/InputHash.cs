using System;
using System.IO;
using System.Security.Cryptography;
using LaserTracking.Session;

namespace LaserTracking.Host.Sessions
{
    /// <summary>Identifies inputs by their content, for the header of events.jsonl.</summary>
    internal static class InputHash
    {
        public static SessionInput Of(string path) => new(path, File.Exists(path) ? Sha256(path) : null);

        private static string Sha256(string path)
        {
            using FileStream stream = File.OpenRead(path);
            return Convert.ToHexString(SHA256.HashData(stream)).ToLowerInvariant();
        }
    }
}
