using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Capture.AzureKinect;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Host.Recordings
{
    [Category("Reference")]
    public sealed class RecordingExtractorTests
    {
        private string _folder = "";

        private static IEnumerable<string> References => KinectReference.All();

        [SetUp]
        public void CreateFolder() => _folder = Path.Combine(Path.GetTempPath(), "range-extract-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void RemoveFolder()
        {
            if (Directory.Exists(_folder))
                Directory.Delete(_folder, recursive: true);
        }

        [TestCaseSource(nameof(References))]
        public void RecordingExtractor_HashesOnly_ListsTheReferencePayloads(string name)
        {
            using KinectReference reference = KinectReference.Open(name);
            ExtractResult result = new RecordingExtractor(reference.Recording, new ExtractOptions { OutputFolder = _folder, HashesOnly = true }).Run();
            JObject[] lines = Lines();
            var captures = (JArray)reference.Json["captures"]!;
            Assert.That(result.Captures, Is.EqualTo(captures.Count));
            int line = 0;
            for (int index = 0; index < captures.Count; index++)
            {
                foreach ((string key, string track) in new[] { ("color", "COLOR"), ("depth", "DEPTH"), ("ir", "IR") })
                {
                    if (captures[index][key] is not JObject expected)
                        continue;
                    JObject actual = lines[line++];
                    Assert.That((int)actual["capture"]!, Is.EqualTo(index));
                    Assert.That((string)actual["track"]!, Is.EqualTo(track));
                    Assert.That((long)actual["time_us"]!, Is.EqualTo((long)expected["device_timestamp_usec"]! + reference.OffsetCorrectionUs));
                    Assert.That((string)expected["format"]!, Does.EndWith((string)actual["format"]!));
                    foreach (string number in new[] { "width", "height", "stride", "size" })
                        Assert.That((int)actual[number]!, Is.EqualTo((int)expected[number]!), number);
                    Assert.That((string)actual["sha256"]!, Is.EqualTo((string)expected["sha256"]!));
                }
            }

            Assert.That(lines.Skip(line).All(custom => custom["capture"]!.Type == JTokenType.Null), Is.True);
            Assert.That(Directory.GetFiles(_folder).Length, Is.EqualTo(1));
        }

        [Test]
        public void RecordingExtractor_Range_WritesTheseFilesWithTheListedContent()
        {
            using KinectReference reference = KinectReference.Open("rec_small.reference.json");
            var options = new ExtractOptions { OutputFolder = _folder, FirstCapture = 5, LastCapture = 6 };
            new RecordingExtractor(reference.Recording, options).Run();
            JObject[] lines = Lines();
            Assert.That(lines.Select(line => (string)line["track"]!), Is.EqualTo(new[] { "COLOR", "COLOR", "DEPTH", "IR", "QA_EVENTS", "QA_EVENTS" }));
            foreach (JObject line in lines)
                Assert.That(KinectReference.Hash(File.ReadAllBytes(Path.Combine(_folder, (string)line["file"]!))), Is.EqualTo((string)line["sha256"]!));
            Assert.That(Directory.GetFiles(_folder).Length, Is.EqualTo(lines.Length + 1), "no temporary file stays");
        }

        [Test]
        public void RecordingExtractor_RangeBehindTheEnd_IsRefusedAndLeavesNoList()
        {
            using KinectReference reference = KinectReference.Open("rec_small.reference.json");
            var options = new ExtractOptions { OutputFolder = _folder, FirstCapture = 50, LastCapture = 60 };
            Assert.Throws<InputException>(() => new RecordingExtractor(reference.Recording, options).Run());
            Assert.That(Directory.GetFiles(_folder), Is.Empty);
        }

        [Test]
        public void RecordingExtractor_Interrupted_KeepsWhatWasFinished()
        {
            using KinectReference reference = KinectReference.Open("rec_small.reference.json");
            using var interrupt = new CancellationTokenSource();
            int calls = 0;
            ExtractResult result = new RecordingExtractor(reference.Recording, new ExtractOptions { OutputFolder = _folder })
                .Run(_ => { if (++calls == 3) interrupt.Cancel(); }, interrupt.Token);
            Assert.That(result.WasCancelled, Is.True);
            Assert.That(result.Captures, Is.EqualTo(3));
            Assert.That(Lines().Length, Is.EqualTo(5), "three colour pictures, one depth, one infrared");
        }

        [Test]
        public void RecordingExtractor_FolderThatIsAFile_IsRefused()
        {
            using KinectReference reference = KinectReference.Open("rec_small.reference.json");
            File.WriteAllText(_folder, "");
            try
            {
                Assert.Throws<InputException>(() => new RecordingExtractor(reference.Recording, new ExtractOptions { OutputFolder = _folder }).Run());
            }
            finally
            {
                File.Delete(_folder);
            }
        }

        private JObject[] Lines() => File.ReadAllLines(Path.Combine(_folder, "frames.jsonl")).Select(line => JObject.Parse(line)).ToArray();
    }
}
