using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Host.Sources;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Sources
{
    public sealed class ImageFolderSourceTests
    {
        private TemporaryFolder _folder = null!;

        [SetUp]
        public void CreateFolder() => _folder = new TemporaryFolder();

        [TearDown]
        public void DeleteFolder() => _folder.Dispose();

        [TestCase("png")]
        [TestCase("bmp")]
        [TestCase("tif")]
        [TestCase("ppm")]
        [TestCase("pgm")]
        [TestCase("jpg")]
        public void TryRead_NumberedPictures_ComeInOrderOfTheirNumbers(string extension)
        {
            // Names without leading zeros: 8, 9, 10, 11. Brightness is ten times the number.
            foreach (int number in new[] { 8, 9, 10, 11 })
                MakePicture($"shot{number}.{extension}", 10 * number);
            List<int> brightness = Read(out IReadOnlyList<FrameProblem> problems, out List<long> times);
            Assert.That(problems, Is.Empty);
            Assert.That(brightness, Has.Count.EqualTo(4));
            for (int i = 0; i < 4; i++)
                Assert.That(brightness[i], Is.InRange(10 * (8 + i) - 2, 10 * (8 + i) + 2));
            Assert.That(times, Is.EqualTo(new[] { 0L, 40_000, 80_000, 120_000 }));
        }

        [Test]
        public void TryRead_DamagedMissingAndOddPictures_AreReportedAndTheRestIsRight()
        {
            foreach (int number in new[] { 1, 2, 3, 4, 6, 7 })
                MakePicture($"frame_{number:D4}.png", 10 * number);
            byte[] bytes = File.ReadAllBytes(_folder.File("frame_0002.png"));
            File.WriteAllBytes(_folder.File("frame_0002.png"), bytes[..(bytes.Length / 2)]);
            MakePicture("frame_0004.png", 40, "32x16");
            List<int> brightness = Read(out IReadOnlyList<FrameProblem> problems, out _);
            Assert.That(brightness, Has.Count.EqualTo(6));
            Assert.That(brightness[1], Is.EqualTo(-1));
            Assert.That(brightness[3], Is.EqualTo(-1));
            foreach ((int index, int expected) in new[] { (0, 10), (2, 30), (4, 60), (5, 70) })
                Assert.That(brightness[index], Is.InRange(expected - 1, expected + 1));
            Assert.That(problems.Select(problem => problem.FrameIndex), Is.EquivalentTo(new[] { 1, 3, 4 }));
            Assert.That(problems.Single(problem => problem.FrameIndex == 3).What, Does.Contain("32×16"));
            Assert.That(problems.Single(problem => problem.FrameIndex == 4).What, Does.StartWith("number 5 is missing"));
        }

        [Test]
        public void TryRead_DamagedAndProgressiveJpeg_OneIsMissingTheOtherRead()
        {
            using var image = new Image();
            for (int number = 1; number <= 3; number++)
            {
                image.Reset(PixelFormat.Yuy2, 48, 32, 0);
                image.Bytes.Fill((byte)128);
                File.WriteAllBytes(_folder.File($"{number}.jpg"), new JpegEncoder().Encode(image).ToArray());
            }

            byte[] bytes = File.ReadAllBytes(_folder.File("2.jpg"));
            File.WriteAllBytes(_folder.File("2.jpg"), bytes[..(bytes.Length - 20)]);
            File.WriteAllBytes(_folder.File("3.jpg"), ProgressiveGray());
            List<int> brightness = Read(out IReadOnlyList<FrameProblem> problems, out _);
            Assert.That(brightness[0], Is.EqualTo(128));
            Assert.That(brightness[1], Is.EqualTo(-1));
            Assert.That(problems[0].What, Does.StartWith("2.jpg: JPEG ends early at byte " + (bytes.Length - 20)));
            Assert.That(brightness[2], Is.InRange(127, 129));
            Assert.That(problems, Has.Count.EqualTo(1));
        }

        [Test]
        public void TryRead_WithFrameList_TakesItsTimesAndFiles()
        {
            MakePicture("capture-000004-COLOR.png", 40);
            MakePicture("capture-000005-COLOR.png", 50);
            File.WriteAllLines(_folder.File("frames.jsonl"),
            [
                """{"capture":4,"track":"COLOR","time_us":1234571,"format":"MJPG","width":48,"height":32,"stride":0,"size":1,"sha256":"00","file":"capture-000004-COLOR.png"}""",
                """{"capture":4,"track":"DEPTH","time_us":1234567,"format":"DEPTH16","size":1,"sha256":"00"}""",
                """{"capture":5,"track":"COLOR","time_us":1267905,"format":"MJPG"}""",
                """{"capture":6,"track":"COLOR","time_us":1300000,"format":"MJPG"}""",
                "{broken",
            ]);
            List<int> brightness = Read(out IReadOnlyList<FrameProblem> problems, out List<long> times);
            Assert.That(times, Is.EqualTo(new[] { 1_234_571L, 1_267_905 }));
            Assert.That(brightness[0], Is.InRange(39, 41));
            Assert.That(brightness[1], Is.InRange(49, 51));
            Assert.That(problems, Has.Count.EqualTo(2));
        }

        [Test]
        public void TryRead_RawPixelsOfAFrameList_AreTakenAsTheyAre()
        {
            File.WriteAllBytes(_folder.File("a.nv12"), Enumerable.Repeat((byte)77, 48 * 32).Concat(Enumerable.Repeat((byte)128, 48 * 16)).ToArray());
            File.WriteAllBytes(_folder.File("b.nv12"), new byte[100]);
            const string line = """{"capture":0,"track":"COLOR","time_us":5,"format":"NV12","width":48,"height":32,"stride":48,"size":2304,"file":"a.nv12"}""";
            File.WriteAllLines(_folder.File("frames.jsonl"), [line, line.Replace(":5,", ":6,").Replace("a.nv12", "b.nv12")]);
            List<int> brightness = Read(out IReadOnlyList<FrameProblem> problems, out List<long> times);
            Assert.That(brightness, Is.EqualTo(new[] { 77, -1 }));
            Assert.That(times, Is.EqualTo(new[] { 5L, 6 }));
            Assert.That(problems.Single().What, Does.StartWith("b.nv12: has 100 bytes"));
        }

        [Test]
        public void OfImageFolder_Pictures_AreCounted()
        {
            for (int number = 0; number < 3; number++)
                MakePicture($"{number}.png", 100);
            var info = VideoInfo.OfImageFolder(_folder.Path, 10);
            Assert.That((string)info["container"]!, Is.EqualTo("images"));
            Assert.That((long)info["captures"]!, Is.EqualTo(3));
            Assert.That((long)info["duration_us"]!, Is.EqualTo(200_000));
            Assert.That((string)info["tracks"]![0]!["format"]!, Is.EqualTo("PNG"));
            Assert.That((int)info["tracks"]![0]!["height"]!, Is.EqualTo(32));
        }

        private void MakePicture(string name, int brightness, string size = "48x32")
        {
            string hex = brightness.ToString("x2");
            FfmpegForTests.Run("-f", "lavfi", "-i", $"color=0x{hex}{hex}{hex}:size={size}:rate=1,format=rgb24", "-frames:v", "1", "-update", "1", _folder.File(name));
        }

        /// <summary>48×32 pixels of 128: a progressive JPEG whose only scan holds 24 DC differences of zero, two zero bits each.</summary>
        private static byte[] ProgressiveGray()
        {
            byte[] quantisation = [0xFF, 0xDB, 0, 67, 0, .. Enumerable.Repeat((byte)8, 64)];
            byte[] frame = [0xFF, 0xC2, 0, 11, 8, 0, 32, 0, 48, 1, 1, 0x11, 0];
            byte[] huffman = [0xFF, 0xC4, 0, 31, 0, 0, 1, 5, 1, 1, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11];
            byte[] scan = [0xFF, 0xDA, 0, 8, 1, 1, 0, 0, 0, 0];
            return [0xFF, 0xD8, .. quantisation, .. frame, .. huffman, .. scan, .. new byte[6], 0xFF, 0xD9];
        }

        /// <summary>Green of the middle pixel of each picture, -1 for one that is absent.</summary>
        private List<int> Read(out IReadOnlyList<FrameProblem> problems, out List<long> times)
        {
            using var source = new ImageFolderSource(_folder.Path, 25);
            using var frame = new Frame();
            using var bgra = new Image();
            var result = new List<int>();
            times = new List<long>();
            for (; source.TryRead(frame); result.Add(frame.Color.IsPresent ? bgra.Bytes[(16 * 48 + 24) * 4 + 1] : -1))
            {
                Assert.That(frame.Index, Is.EqualTo(times.Count));
                times.Add(frame.TimeUs);
                if (frame.Color.IsPresent)
                    ColorConversion.ToBgra(frame.Color, bgra);
            }

            problems = source.Problems;
            return result;
        }
    }
}
