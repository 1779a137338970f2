using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json.Nodes;
using LaserTracking.Capture.AzureKinect;
using NUnit.Framework;

namespace LaserTracking.Host.Recordings
{
    [Category("Reference")]
    public sealed class RecordingInfoTests
    {
        private static IEnumerable<string> References => KinectReference.All();

        [TestCaseSource(nameof(References))]
        public void RecordingInfo_OfAReferenceRecording_SaysWhatTheReferenceSays(string name)
        {
            using KinectReference reference = KinectReference.Open(name);
            JsonObject info = new RecordingInfo(reference.Recording).Build();
            Newtonsoft.Json.Linq.JObject expected = reference.Json;
            Assert.That((string?)info["container"], Is.EqualTo("k4a-mkv"));
            Assert.That((long)info["duration_us"]!, Is.EqualTo((long)expected["recording_length_usec"]!));
            Assert.That((bool)info["truncated"]!, Is.False);
            Assert.That((long)info["captures"]!, Is.EqualTo((long)expected["capture_count"]!));
            Assert.That((string?)info["depth_mode"], Is.EqualTo((string?)expected["record_configuration"]!["depth_mode"]));
            Assert.That((string?)info["device"]?["serial"], Is.EqualTo((string?)expected["tags"]!["K4A_DEVICE_SERIAL_NUMBER"]));
            Assert.That((string?)info["sync"]!["mode"], Is.EqualTo((string?)expected["record_configuration"]!["wired_sync_mode"]));
            Assert.That(info["calibration"] != null, Is.EqualTo((long)expected["calibration_attachment"]!["size"]! > 0));
            Assert.That(info["problems"]!.AsArray(), Is.Empty);
            foreach ((string track, string count) in new[] { ("COLOR", "color"), ("DEPTH", "depth"), ("IR", "ir") })
            {
                JsonNode? actual = info["tracks"]!.AsArray().SingleOrDefault(candidate => (string?)candidate!["name"] == track);
                Assert.That((long?)actual?["frames"] ?? 0, Is.EqualTo((long)expected["image_counts"]![count]!));
            }
        }

        [TestCase("bad_truncated_mid_cluster.mkv", 7, true)]
        [TestCase("bad_unflushed.mkv", 12, true)]
        [TestCase("bad_corrupt_payload.mkv", 12, false)]
        [TestCase("bad_corrupt_block_size.mkv", 11, false)]
        public void RecordingInfo_OfADamagedRecording_ListsTheProblems(string name, int captures, bool truncated)
        {
            using KinectRecording recording = KinectRecording.Open(TestFiles.Reference("k4a", name));
            JsonObject info = new RecordingInfo(recording).Build();
            Assert.That((long)info["captures"]!, Is.EqualTo(captures));
            Assert.That((bool)info["truncated"]!, Is.EqualTo(truncated));
            Assert.That(info["problems"]!.AsArray().Count, Is.GreaterThan(0));
        }

        [Test]
        public void RecordingInfo_CalibrationWithNaN_IsAProblemAndTheRestStands()
        {
            byte[] bytes = File.ReadAllBytes(TestFiles.Reference("k4a", "rec_small.mkv"));
            int parameters = bytes.AsSpan().IndexOf("\"ModelParameters\""u8);
            int number = parameters + bytes.AsSpan(parameters).IndexOf("0."u8);
            "NaN"u8.CopyTo(bytes.AsSpan(number));
            using var recording = new KinectRecording(new MemoryStream(bytes), "rec_small.mkv");
            JsonObject info = new RecordingInfo(recording).Build();
            Assert.That(info["problems"]!.AsArray().Select(problem => (string?)problem!["what"]), Has.One.Contains("calibration.json cannot be read"));
            Assert.That((long)info["captures"]!, Is.EqualTo(12));
        }
    }
}
