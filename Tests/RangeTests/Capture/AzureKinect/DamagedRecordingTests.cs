using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Damaged recordings: what is recoverable is recovered, and what is not is said.</summary>
    [Category("Reference")]
    public sealed class DamagedRecordingTests
    {
        private static IEnumerable<string> Files
        {
            get
            {
                string path = Path.Combine(TestFiles.Data, "k4a", "bad_files.reference.json");
                return File.Exists(path) ? JArray.Parse(File.ReadAllText(path)).Select(entry => (string)entry["file"]!).ToArray() : new[] { "" };
            }
        }

        [TestCaseSource(nameof(Files))]
        public void KinectRecording_DamagedFile_GivesWhatIsRecoverable(string name)
        {
            JToken entry = Entry(name);
            string path = TestFiles.Reference("k4a", name);
            JToken? captures = entry["genuine_playback"]!["captures"];
            JToken? blocks = entry["recoverable_blocks"];
            if (captures == null && blocks == null)
            {
                InputException? exception = Assert.Throws<InputException>(() => KinectRecording.Open(path).Dispose());
                Assert.That(exception!.Message, Does.StartWith(path + ": ").And.Contain("; ").And.Not.Contain("\n"));
                return;
            }

            using KinectRecording recording = KinectRecording.Open(path);
            recording.VerifiesChecksums = true;
            if (captures != null)
                AssertCaptures(recording, (JArray)captures);
            else
                AssertBlocks(recording, (JObject)blocks!);
            Assert.That(recording.Problems, Is.Not.Empty);
            Assert.That(recording.Problems, Has.All.Matches<FrameProblem>(problem => problem.What.Length > 0 && !problem.What.Contains('\n')));
        }

        [Test]
        public void KinectRecording_CutMidCluster_HasSixWholeCapturesAndTheColorOfTheSeventh()
        {
            using KinectRecording recording = KinectRecording.Open(TestFiles.Reference("k4a", "bad_truncated_mid_cluster.mkv"));
            var capture = new KinectCapture();
            int count = 0;
            while (recording.TryReadNext(capture))
                count++;
            Assert.That(count, Is.EqualTo(7));
            Assert.That(recording.IsCut, Is.True);
            Assert.That(recording.TryReadPrevious(capture), Is.True);
            Assert.That(capture.Index, Is.EqualTo(6));
            Assert.That(capture.Color.IsPresent && !capture.Depth.IsPresent && !capture.Infrared.IsPresent, Is.True);
            Assert.That(recording.Problems.Select(problem => problem.What), Has.Some.Contains("ends inside a cluster"));
        }

        [Test]
        public void KinectRecording_ChangedPayload_MarksTheCapturesWhoseChecksumDoesNotFit()
        {
            using KinectRecording recording = KinectRecording.Open(TestFiles.Reference("k4a", "bad_corrupt_payload.mkv"));
            recording.VerifiesChecksums = true;
            var capture = new KinectCapture();
            var suspect = new List<int>();
            while (recording.TryReadNext(capture))
            {
                if (capture.Color.IsSuspect)
                    suspect.Add(capture.Index);
            }

            Assert.That(suspect, Is.EqualTo(new[] { 3, 6 }));
            Assert.That(recording.Problems.Count, Is.EqualTo(2));
        }

        [Test]
        public void KinectRecording_OversizedBlock_IsReportedAtItsOffset()
        {
            using KinectRecording recording = KinectRecording.Open(TestFiles.Reference("k4a", "bad_corrupt_block_size.mkv"));
            var capture = new KinectCapture();
            while (recording.TryReadNext(capture))
            {
            }

            // The reference names the size field; the block's element begins one byte before it.
            Assert.That(recording.Problems.Select(problem => problem.Offset), Is.EqualTo(new[] { 457458L }));
        }

        [Test]
        public void KinectRecording_RecorderKilled_HasAllTwelveCapturesWithoutStartOffset()
        {
            using KinectRecording recording = KinectRecording.Open(TestFiles.Reference("k4a", "bad_unflushed.mkv"));
            var capture = new KinectCapture();
            int count = 0;
            while (recording.TryReadNext(capture))
                count++;
            Assert.That(count, Is.EqualTo(12));
            Assert.That(recording.Configuration.StartOffsetUs, Is.Zero);
            // Its last motion block begins at 366663 and lasts 9001 us; the four samples after it were never written.
            Assert.That(recording.LengthUs, Is.EqualTo(375663));
            Assert.That(recording.IsCut, Is.True);
        }

        [TestCase("no-such-file.mkv", "no such file")]
        [TestCase("", "is a folder")]
        public void KinectRecording_NoFile_SaysSo(string name, string expected)
        {
            string path = Path.Combine(AppContext.BaseDirectory, name);
            InputException? exception = Assert.Throws<InputException>(() => KinectRecording.Open(path));
            Assert.That(exception!.Message, Does.Contain(expected));
        }

        private static JToken Entry(string name)
        {
            if (name.Length == 0)
                Assert.Ignore("reference data not there: " + Path.Combine(TestFiles.Data, "k4a", "bad_files.reference.json"));
            return JArray.Parse(File.ReadAllText(TestFiles.Reference("k4a", "bad_files.reference.json"))).Single(entry => (string)entry["file"]! == name);
        }

        private static void AssertCaptures(KinectRecording recording, JArray expected)
        {
            var capture = new KinectCapture();
            for (int index = 0; index < expected.Count; index++)
            {
                Assert.That(recording.TryReadNext(capture), Is.True);
                AssertImage(capture.Color, expected[index]["color"]!);
                AssertImage(capture.Depth, expected[index]["depth"]!);
                AssertImage(capture.Infrared, expected[index]["ir"]!);
            }

            Assert.That(recording.TryReadNext(capture), Is.False);

            void AssertImage(in KinectImage actual, JToken image)
            {
                Assert.That(actual.IsPresent, Is.EqualTo(image.Type != JTokenType.Null));
                if (!actual.IsPresent)
                    return;
                Assert.That(actual.DeviceTimeUs, Is.EqualTo((long)image["device_timestamp_usec"]!));
                Assert.That(Hash(recording, actual), Is.EqualTo((string)image["sha256"]!));
            }
        }

        private static void AssertBlocks(KinectRecording recording, JObject expected)
        {
            var capture = new KinectCapture();
            var found = new Dictionary<string, List<string>> { ["COLOR"] = new List<string>(), ["DEPTH"] = new List<string>(), ["IR"] = new List<string>() };
            while (recording.TryReadNext(capture))
            {
                Add("COLOR", capture.Color);
                Add("DEPTH", capture.Depth);
                Add("IR", capture.Infrared);
            }

            foreach (KinectTrack track in recording.Tracks.Where(track => !track.IsBuiltin))
            {
                var lines = new List<string>();
                KinectDataReader reader = recording.CreateDataReader(track);
                while (reader.TryReadNext(out KinectDataBlock data))
                {
                    var payload = new byte[data.SizeBytes];
                    Assert.That(recording.TryReadPayload(data, payload), Is.True);
                    lines.Add(data.DeviceTimeUs - recording.Configuration.StartOffsetUs + " " + KinectReference.Hash(payload));
                }

                found.Add(track.Name, lines);
            }

            foreach (JProperty track in expected.Properties().Where(property => property.Value is JArray))
                Assert.That(found[track.Name], Is.EqualTo(track.Value.Select(block => block["relative_timestamp_usec"] + " " + block["sha256"])), track.Name);

            void Add(string name, in KinectImage image)
            {
                if (image.IsPresent)
                    found[name].Add(image.DeviceTimeUs - recording.Configuration.StartOffsetUs + " " + Hash(recording, image));
            }
        }

        private static string Hash(KinectRecording recording, in KinectImage image)
        {
            var payload = new byte[image.SizeBytes];
            Assert.That(recording.TryReadPayload(image, payload), Is.True);
            return KinectReference.Hash(payload);
        }
    }
}
