using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using LaserTracking.Capture.Recording;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>What our recorder writes, read by FFmpeg and MKVToolNix: finished, killed and copied.</summary>
    public sealed class RecordingPeerTests
    {
        private const int Frames = 5;

        private static string Record(TemporaryFolder folder, PixelFormat color, bool withDepth, PixelRegion? region = null, int jpeg = 0)
        {
            string path = folder.File("recorded.mkv");
            using var recorder = new FrameRecorder(path, new FrameRecorderSettings { WaitsWhenFull = true, Region = region, JpegQuality = jpeg, DeviceCalibration = () => new byte[] { (byte)'{', (byte)'}' } });
            for (int i = 0; i < Frames; i++)
                recorder.Add(Picture(i, color, withDepth));
            return path;
        }

        private static Frame Picture(int index, PixelFormat color, bool withDepth)
        {
            var random = new Random(index);
            var frame = new Frame();
            long timeUs = 5000000 + index * 33333L;
            frame.Begin(index, timeUs);
            frame.Color.Reset(color, 64, 48, timeUs);
            random.NextBytes(frame.Color.Bytes);
            if (!withDepth)
                return frame;
            frame.Depth.Reset(PixelFormat.Depth16, 320, 288, timeUs);
            random.NextBytes(frame.Depth.Bytes);
            return frame;
        }

        private static void AssertNoComplaint(string path)
        {
            (int exitCode, string output, string error) = ToolForTests.Run("ffprobe", "-v", "error", "-show_packets", path);
            Assert.That((exitCode, error.Trim()), Is.EqualTo((0, "")));
            Assert.That(output, Does.Contain("[PACKET]"));
            (exitCode, output, error) = ToolForTests.Run("mkvinfo", "-a", "--ui-language", "en_US", path);
            Assert.That((exitCode, error.Trim()), Is.EqualTo((0, "")), output);
            Assert.That(output.Split('\n').Where(line => line.StartsWith('(') || line.Contains("Error") || line.Contains("Unknown") || line.Contains("resync")), Is.Empty);
            (exitCode, output, _) = ToolForTests.Run("mkvmerge", "--ui-language", "en_US", "-J", path);
            JObject identified = JObject.Parse(output);
            Assert.That((exitCode, identified["errors"]!.Count(), identified["warnings"]!.Count()), Is.EqualTo((0, 0, 0)), output);
        }

        [Test]
        public void Recording_OfAnyFormat_IsReadByOthersWithoutComplaint(
            [Values(PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8)] PixelFormat color, [Values] bool withDepth)
        {
            using var folder = new TemporaryFolder();
            AssertNoComplaint(Record(folder, color, withDepth));
        }

        [TestCase(PixelFormat.Bgra32, "bgra")]
        [TestCase(PixelFormat.Nv12, "nv12")]
        [TestCase(PixelFormat.Yuy2, "yuyv422")]
        [TestCase(PixelFormat.Gray8, "gray")]
        public void Recording_DecodedByFfmpeg_GivesTheSamePixels(PixelFormat color, string name)
        {
            using var folder = new TemporaryFolder();
            string path = Record(folder, color, true);
            byte[] decoded = FfmpegForTests.Run("-i", path, "-map", "0:0", "-f", "rawvideo", "-pix_fmt", name, "-");
            byte[] depth = FfmpegForTests.Run("-i", path, "-map", "0:1", "-f", "rawvideo", "-pix_fmt", "gray16le", "-");
            Frame[] frames = Enumerable.Range(0, Frames).Select(i => Picture(i, color, true)).ToArray();
            Assert.That(decoded.AsSpan().SequenceEqual(frames.SelectMany(f => f.Color.Bytes.ToArray()).ToArray()), Is.True, "colour");
            Assert.That(depth.AsSpan().SequenceEqual(frames.SelectMany(f => f.Depth.Bytes.ToArray()).ToArray()), Is.True, "depth");
        }

        [Test]
        public void Recording_Jpeg_IsReadByOthersWithoutComplaint()
        {
            using var folder = new TemporaryFolder();
            AssertNoComplaint(Record(folder, PixelFormat.Yuy2, false, null, 90));
        }

        [Test]
        public void Recording_Times_AreWhatFfprobeSays()
        {
            using var folder = new TemporaryFolder();
            (_, string output, _) = ToolForTests.Run("ffprobe", "-v", "error", "-select_streams", "0", "-show_entries", "packet=pts_time", "-of", "csv=p=0", Record(folder, PixelFormat.Nv12, true));
            double[] times = output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => double.Parse(line.Trim(','), CultureInfo.InvariantCulture)).ToArray();
            Assert.That(times, Is.EqualTo(Enumerable.Range(0, Frames).Select(i => i * 0.033333)).Within(1e-9));
        }

        [Test]
        public void Recording_Killed_IsReadByOthersUpToTheCut()
        {
            using var folder = new TemporaryFolder();
            string path = folder.File("killed.mkv");
            using (FileStream file = File.Create(path))
            {
                var writer = new KinectRecordingWriter(file, KinectRecordingHead.Of(Picture(0, PixelFormat.Nv12, true), KinectStreams.All, 30));
                for (int i = 0; i < Frames; i++)
                    writer.Write(Picture(i, PixelFormat.Nv12, true));
            }

            AssertNoComplaint(path);
            (_, string output, _) = ToolForTests.Run("ffprobe", "-v", "error", "-count_packets", "-show_entries", "stream=nb_read_packets", "-of", "csv=p=0", path);
            Assert.That(output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => line.Trim(',')), Is.All.EqualTo(Frames.ToString(CultureInfo.InvariantCulture)));
        }

        [Test]
        [Category("Reference")]
        public void Copies_OfAllReferenceRecordings_AreReadByOthersWithoutComplaint()
        {
            string[] recordings = Directory.GetFiles(TestFiles.Reference("k4a"), "rec_*.mkv");
            Assert.That(recordings, Is.Not.Empty);
            using var folder = new TemporaryFolder();
            foreach (string path in recordings)
            {
                string copy = folder.File(Path.GetFileName(path));
                using (KinectRecording source = KinectRecording.Open(path))
                using (FileStream target = File.Create(copy))
                    KinectRecordingCopier.Copy(source, target);
                (int exitCode, string output, _) = ToolForTests.Run("mkvmerge", "--ui-language", "en_US", "-J", copy);
                JObject identified = JObject.Parse(output);
                Assert.That((exitCode, identified["errors"]!.Count(), identified["warnings"]!.Count()), Is.EqualTo((0, 0, 0)), output);
                Assert.That(Packets(copy), Is.EqualTo(Packets(path)), Path.GetFileName(path));
            }
        }

        /// <summary>Every packet with its time and a hash of its bytes, by track.</summary>
        private static IEnumerable<string> Packets(string path)
        {
            (_, string output, _) = ToolForTests.Run("ffprobe", "-v", "fatal", "-show_packets", "-show_data_hash", "md5", "-show_entries", "packet=stream_index,pts_time,data_hash", "-of", "csv=p=0", path);
            return output.Split('\n', StringSplitOptions.RemoveEmptyEntries).OrderBy(line => line, StringComparer.Ordinal);
        }
    }
}
