using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using LaserTracking.Capture;
using LaserTracking.Host.Sources;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Sources
{
    public sealed class VideoSourceTests
    {
        private TemporaryFolder _folder = null!;

        [SetUp]
        public void CreateFolder() => _folder = new TemporaryFolder();

        [TearDown]
        public void DeleteFolder() => _folder.Dispose();

        [Test]
        public void TryRead_UnevenTimes_AreThoseOfTheFile()
        {
            // Frame n is shown at 1.5 s + 10·n² ms and has brightness 8·n.
            string path = MakeUnevenVideo("uneven.mkv");
            using var source = new VideoSource(path);
            Assert.That((source.Info.Width, source.Info.Height), Is.EqualTo((64, 48)));
            using var frame = new Frame();
            for (int n = 0; n < 20; n++)
            {
                Assert.That(source.TryRead(frame), Is.True, "frame " + n);
                Assert.That(frame.Index, Is.EqualTo(n));
                Assert.That(frame.TimeUs, Is.EqualTo(1_500_000 + 10_000L * n * n));
                Assert.That(frame.Color.TimeUs, Is.EqualTo(frame.TimeUs));
                Assert.That(frame.Color.Format, Is.EqualTo(PixelFormat.Bgra32));
                Assert.That((double)frame.Color.Bytes[64 * 4 * 24 + 64 * 2 + 1], Is.EqualTo(8.0 * n).Within(3));
            }

            Assert.That(source.TryRead(frame), Is.False);
            Assert.That(source.TryRead(frame), Is.False);
            Assert.That(source.Problems, Is.Empty);
        }

        [Test]
        public void TryRead_Twice_GivesTheSameBytes()
        {
            string path = _folder.File("moving.mp4");
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=322x242:rate=25:duration=2", "-c:v", "mpeg4", "-bf", "2", path);
            (string Hash, List<long> Times) first = Digest(path);
            (string Hash, List<long> Times) second = Digest(path);
            Assert.That(second.Hash, Is.EqualTo(first.Hash));
            Assert.That(second.Times, Is.EqualTo(first.Times));
            Assert.That(first.Times, Is.EqualTo(Enumerable.Range(0, 50).Select(n => n * 40_000L)));
        }

        [Test]
        public void TryRead_StreamWithoutTimes_CountsFramesAtItsRate()
        {
            string path = _folder.File("raw.m4v");
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=1", "-c:v", "mpeg4", "-f", "m4v", path);
            Assert.That(Digest(path).Times, Is.EqualTo(Enumerable.Range(0, 10).Select(n => n * 100_000L)));
        }

        [Test]
        public void TryRead_SizeChangesInside_ScalesToTheFirst()
        {
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=1", "-c:v", "mpeg2video", "-f", "mpegts", _folder.File("a.ts"));
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=96x80:rate=10:duration=1", "-c:v", "mpeg2video", "-f", "mpegts",
                "-output_ts_offset", "1", _folder.File("b.ts"));
            string path = _folder.File("both.ts");
            File.WriteAllBytes(path, [.. File.ReadAllBytes(_folder.File("a.ts")), .. File.ReadAllBytes(_folder.File("b.ts"))]);
            using var source = new VideoSource(path);
            using var frame = new Frame();
            int count = 0;
            for (; source.TryRead(frame); count++)
                Assert.That((frame.Color.Width, frame.Color.Height), Is.EqualTo((64, 48)));
            Assert.That(count, Is.GreaterThanOrEqualTo(19));
        }

        [TestCase("cut.mkv")]
        [TestCase("cut.avi")]
        public void TryRead_CutVideo_GivesTheFramesUntilThereThenAProblem(string name)
        {
            string whole = _folder.File("whole" + Path.GetExtension(name));
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=160x120:rate=25:duration=4", "-c:v", "mjpeg", "-q:v", "4", whole);
            string path = _folder.File(name);
            byte[] bytes = File.ReadAllBytes(whole);
            File.WriteAllBytes(path, bytes[..(bytes.Length / 2)]);
            using var source = new VideoSource(path);
            using var frame = new Frame();
            int count = 0;
            while (source.TryRead(frame))
                count++;
            Assert.That(count, Is.InRange(40, 60));
            Assert.That(source.Problems[^1].What, Does.StartWith($"the video breaks off after {count}"));
            Assert.That((bool)VideoInfo.OfVideo(path)["truncated"]!, Is.True);
            Assert.That(source.Problems.All(problem => problem.What.Length > 0 && !problem.What.Contains('\n')), Is.True);
        }

        [Test]
        public void Open_ThingsThatAreNoVideo_SayWhatIsWrongInOneLine()
        {
            FfmpegForTests.Run("-version");
            string noise = _folder.File("noise.mp4");
            File.WriteAllBytes(noise, Enumerable.Range(0, 5000).Select(i => (byte)(i * i * 7 >> 3)).ToArray());
            string text = _folder.File("notes.txt");
            File.WriteAllText(text, "not a video\n");
            string sound = _folder.File("sound.wav");
            FfmpegForTests.Run("-f", "lavfi", "-i", "sine=duration=0.2", sound);
            string headless = _folder.File("headless.mp4");
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=64x48:rate=10:duration=1", "-c:v", "mpeg4", headless);
            byte[] bytes = File.ReadAllBytes(headless);
            File.WriteAllBytes(headless, bytes[..(bytes.Length / 2)]);
            foreach (string path in new[] { noise, text, sound, headless })
            {
                InputException exception = Assert.Throws<InputException>(() => new VideoSource(path).Dispose())!;
                Assert.That(exception.Message, Does.StartWith(path + ": "));
                Assert.That(exception.Message, Does.Not.Contain("\n"));
                Assert.That(exception.Message, Does.Not.Contain("0x"));
            }
        }

        [Test]
        public void Open_WithoutFfmpeg_NamesTheCommandThatInstallsIt()
        {
            string path = _folder.File("video.mp4");
            File.WriteAllBytes(path, new byte[100]);
            string? variable = Environment.GetEnvironmentVariable("PATH");
            try
            {
                Environment.SetEnvironmentVariable("PATH", _folder.Path);
                InputException exception = Assert.Throws<InputException>(() => new VideoSource(path).Dispose())!;
                Assert.That(exception.Message, Does.Match("(apt-get|winget|brew) install ffmpeg$"));
                Assert.That(exception.Message, Does.Not.Contain("\n"));
            }
            finally
            {
                Environment.SetEnvironmentVariable("PATH", variable);
            }
        }

        [Test]
        public void Dispose_InTheMiddle_EndsTheProcess()
        {
            string path = _folder.File("long.mkv");
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=640x480:rate=30:duration=5", "-c:v", "mpeg4", path);
            int id;
            using (var source = new VideoSource(path))
            using (var frame = new Frame())
            {
                Assert.That(source.TryRead(frame), Is.True);
                id = source.ProcessId;
                Assert.That(Process.GetProcessById(id).HasExited, Is.False);
            }

            Assert.That(() => Process.GetProcessById(id), Throws.ArgumentException);
        }

        [Test]
        public void TryRead_Warm_AllocatesNothing()
        {
            string path = _folder.File("video.mkv");
            FfmpegForTests.Run("-f", "lavfi", "-i", "testsrc2=size=320x240:rate=30:duration=2", "-c:v", "mpeg4", path);
            using var source = new VideoSource(path);
            using var frame = new Frame();
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 7; i++)
                    source.TryRead(frame);
            });
            Assert.That(allocated, Is.Zero);
            Assert.That(frame.Index, Is.EqualTo(7 * 7 - 1));
        }

        [Test]
        public void OfVideo_UnevenVideo_CountsItsFrames()
        {
            var info = VideoInfo.OfVideo(MakeUnevenVideo("uneven.mkv"));
            Assert.That((string)info["container"]!, Is.EqualTo("video"));
            Assert.That((long)info["captures"]!, Is.EqualTo(20));
            Assert.That((long)info["tracks"]![0]!["frames"]!, Is.EqualTo(20));
            Assert.That((int)info["tracks"]![0]!["width"]!, Is.EqualTo(64));
            Assert.That((long)info["start_offset_us"]!, Is.EqualTo(1_500_000));
            Assert.That((bool)info["truncated"]!, Is.False);
            Assert.That(info["problems"]!.AsArray(), Is.Empty);
        }

        private string MakeUnevenVideo(string name)
        {
            string path = _folder.File(name);
            FfmpegForTests.Run("-f", "lavfi", "-i", "color=black:size=64x48:rate=10:duration=2", "-vf",
                "geq=lum='16+8*N*219/255':cb=128:cr=128,settb=1/1000,setpts=10*N*N", "-fps_mode", "passthrough", "-enc_time_base", "1:1000",
                "-output_ts_offset", "1.5", "-c:v", "ffv1", path);
            return path;
        }

        private static (string Hash, List<long> Times) Digest(string path)
        {
            using var source = new VideoSource(path);
            using var frame = new Frame();
            using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
            var times = new List<long>();
            while (source.TryRead(frame))
            {
                times.Add(frame.TimeUs);
                hash.AppendData(frame.Color.Bytes);
            }

            return (Convert.ToHexString(hash.GetHashAndReset()), times);
        }
    }
}
