using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>One recording of the reference data with what the genuine playback library returned for it.</summary>
    internal sealed class KinectReference : IDisposable
    {
        private const string Copied = " copied";

        private KinectReference(string jsonPath, bool isCopied)
        {
            Json = JObject.Parse(File.ReadAllText(jsonPath));
            Recording = KinectRecording.Open(Path.Combine(Path.GetDirectoryName(jsonPath)!, (string)Json["file"]!));
            if (isCopied)
                Recording = Copy(Recording);
            long trueOffsetUs = (long)((ulong?)Json["tags"]?["K4A_START_OFFSET_NS"] ?? 0) / 1000;
            OffsetCorrectionUs = trueOffsetUs - (long)Json["record_configuration"]!["start_timestamp_offset_usec"]!;
        }

        public JObject Json { get; }

        public KinectRecording Recording { get; }

        /// <summary>The genuine library keeps 32 bits of the start offset: what its device times lack.</summary>
        public long OffsetCorrectionUs { get; }

        /// <summary>Names of all reference files that are there; one empty name when there are none.</summary>
        public static IEnumerable<string> All()
        {
            string folder = Path.Combine(TestFiles.Data, "k4a");
            string[] names = !Directory.Exists(folder) ? Array.Empty<string>() : Directory.GetFiles(folder, "*.reference.json")
                .Where(path => File.ReadAllText(path).TrimStart().StartsWith('{'))
                .Select(path => Path.GetFileName(path)).OrderBy(name => name, StringComparer.Ordinal).ToArray();
            return names.Length > 0 ? names : new[] { "" };
        }

        /// <summary>The same, each also as our own recorder writes it.</summary>
        public static IEnumerable<string> AllAndCopies() => All().Concat(All().Where(name => name.Length > 0).Select(name => name + Copied));

        public static KinectReference Open(string name)
        {
            if (name.Length == 0)
                Assert.Ignore("reference data not there: " + Path.Combine(TestFiles.Data, "k4a", "*.reference.json"));
            bool isCopied = name.EndsWith(Copied, StringComparison.Ordinal);
            return new KinectReference(TestFiles.Reference("k4a", isCopied ? name[..^Copied.Length] : name), isCopied);
        }

        private static KinectRecording Copy(KinectRecording recording)
        {
            var copy = new MemoryStream();
            using (recording)
                KinectRecordingCopier.Copy(recording, copy);
            return new KinectRecording(copy, recording.Name);
        }

        public string PayloadHash(in KinectImage image)
        {
            var payload = new byte[image.SizeBytes];
            Assert.That(Recording.TryReadPayload(image, payload), Is.True);
            return Hash(payload);
        }

        public static string Hash(byte[] bytes) => Convert.ToHexString(SHA256.HashData(bytes)).ToLowerInvariant();

        /// <summary>Device times of a capture's pictures as "colour depth infrared", "-" for none.</summary>
        public static string Times(KinectCapture capture) => Time(capture.Color) + " " + Time(capture.Depth) + " " + Time(capture.Infrared);

        /// <summary>The same from a capture or seek result of the reference.</summary>
        public string Times(JToken expected)
        {
            return expected.Type == JTokenType.String ? (string)expected! : string.Join(" ", new[] { "color", "depth", "ir" }.Select(Time));

            string Time(string name)
            {
                JToken? value = expected[name];
                if (value is JObject image)
                    value = image["device_timestamp_usec"];
                return value == null || value.Type == JTokenType.Null ? "-" : ((long)value + OffsetCorrectionUs).ToString();
            }
        }

        public void Dispose() => Recording.Dispose();

        private static string Time(in KinectImage image) => image.IsPresent ? image.DeviceTimeUs.ToString() : "-";
    }
}
