using System;
using System.IO;
using System.Security.Cryptography;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// One of the two files that are known to work: MediaPipe's hand landmark models, Apache-2.0, from the npm package
    /// <see cref="Package"/>. They are not part of this one.
    /// </summary>
    public sealed class HandModelFile
    {
        /// <summary>npm package and version that hold both files.</summary>
        public const string Package = "@mediapipe/hands@0.4.1675469240";

        private HandModelFile(string name, string fileName, int sizeBytes, string sha256)
        {
            Name = name;
            FileName = fileName;
            SizeBytes = sizeBytes;
            Sha256 = sha256;
        }

        /// <summary>146 million multiply-adds a hand.</summary>
        public static HandModelFile Lite { get; } =
            new HandModelFile("lite", "hand_landmark_lite.tflite", 2_071_408, "d7fde8ac11f8ce03f8663775bfc323f4fc9f2a38062b4f4efa142874ef5b2a48");

        /// <summary>331 million multiply-adds a hand.</summary>
        public static HandModelFile Full { get; } =
            new HandModelFile("full", "hand_landmark_full.tflite", 5_478_688, "8c026882c9ec059ce0f8e75266bee5a9a23c341a40e0000df755374d3d1b9b68");

        /// <summary>"lite" or "full".</summary>
        public string Name { get; }

        public string FileName { get; }

        public int SizeBytes { get; }

        /// <summary>Lower-case hexadecimal digits.</summary>
        public string Sha256 { get; }

        /// <summary>Which of the two a file claims to be by its name: full when it says so, else lite.</summary>
        public static HandModelFile ByName(string path) => Path.GetFileName(path).IndexOf(Full.Name, StringComparison.OrdinalIgnoreCase) >= 0 ? Full : Lite;

        /// <summary>The file's bytes, once they have been found to be the right ones.</summary>
        /// <exception cref="InputException">It is not there, cut, another file, or cannot be read.</exception>
        public byte[] Read(string path)
        {
            byte[] bytes;
            try
            {
                if (!File.Exists(path))
                    throw new InputException(path, "the hand model is not there", "run './range models' to fetch it");
                long length = new FileInfo(path).Length;
                if (length != SizeBytes)
                    throw new InputException(path, FormattableString.Invariant($"has {length} bytes, the {Name} hand model has {SizeBytes}"), "run './range models' to fetch it again");
                bytes = File.ReadAllBytes(path);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read (" + exception.Message.Replace('\n', ' ').TrimEnd('.') + ")", "check its permissions");
            }

            using SHA256 hash = SHA256.Create();
            string found = BitConverter.ToString(hash.ComputeHash(bytes)).Replace("-", string.Empty).ToLowerInvariant();
            if (found != Sha256)
                throw new InputException(path, "is not the " + Name + " hand model (SHA-256 " + found.Substring(0, 12) + "… instead of " + Sha256.Substring(0, 12) + "…)",
                    "run './range models' to fetch it again");
            return bytes;
        }
    }
}
