using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Host.Sources;
using NUnit.Framework;

namespace LaserTracking.Sources
{
    public sealed class FrameSourcesTests
    {
        private static IEnumerable<string> Recordings()
        {
            string folder = Path.Combine(TestFiles.Data, "k4a");
            return Directory.Exists(folder)
                ? Directory.GetFiles(folder, "*.mkv").Select(path => Path.GetFileName(path)).Where(name => name is not ("bad_empty.mkv" or "bad_not_matroska.mkv"))
                : [];
        }

        [TestCaseSource(nameof(Recordings))]
        public void Detect_RecordingsOfDepthCameras_AlsoDamagedOnes(string name)
        {
            Assert.That(FrameSources.Detect(TestFiles.Reference("k4a", name)), Is.EqualTo(FrameSourceKind.AzureKinectRecording));
        }

        [Test]
        public void Detect_PlainMatroska_IsAVideo()
        {
            using var folder = new TemporaryFolder();
            string path = folder.File("plain.mkv");
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=1", "-c:v", "mjpeg", path);
            Assert.That(FrameSources.Detect(path), Is.EqualTo(FrameSourceKind.Video));
            using IFrameSource source = FrameSources.OpenScreenCamera(path);
            Assert.That(source, Is.InstanceOf<VideoSource>());
        }

        [Test]
        public void Open_MissingEmptyOrPictureless_SaysWhatIsWrongInOneLine()
        {
            using var folder = new TemporaryFolder();
            string empty = folder.File("empty.mkv");
            File.WriteAllBytes(empty, []);
            foreach ((string path, string what) in new[]
                { (folder.File("nowhere.mp4"), "does not exist"), (empty, "is empty"), (folder.Path, "folder without pictures") })
            {
                InputException exception = Assert.Throws<InputException>(() => FrameSources.OpenScreenCamera(path).Dispose())!;
                Assert.That(exception.Message, Does.StartWith(path + ": ").And.Contain(what).And.Not.Contain("\n"));
            }
        }
    }
}
