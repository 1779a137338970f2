using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    /// <summary>Boards in real photographs beside OpenCV's corners, and no boards where there are none.</summary>
    [Category("Reference")]
    public sealed class BoardReferenceTests
    {
        private static readonly BoardSize NineBySix = new(9, 6);

        private readonly CheckerboardFinder _finder = new();
        private readonly JpegDecoder _decoder = new();
        private readonly Image _picture = new();

        [OneTimeTearDown]
        public void TearDown()
        {
            _finder.Dispose();
            _picture.Dispose();
        }

        [Test]
        public void TryFind_EveryReferencePhotograph_GivesOpenCvsCornersInItsOrder()
        {
            var errors = new List<double>();
            var missed = new List<string>();
            foreach ((string name, Vector2D[] expected) in References())
            {
                Load(name);
                var corners = new Vector2D[NineBySix.Count];
                if (!_finder.TryFind(_picture, NineBySix, corners, out string reason))
                    missed.Add(name + ": " + reason);
                for (int i = 0; i < corners.Length; i++)
                    errors.Add((corners[i] - expected[i]).Length);
            }

            Assert.That(missed, Is.Empty);
            errors.Sort();
            double median = errors[errors.Count / 2], p95 = errors[(int)(0.95 * errors.Count)];
            TestContext.Out.WriteLine(FormattableString.Invariant($"{errors.Count} corners, median {median:F4} px, p95 {p95:F4} px, worst {errors[^1]:F4} px"));
            Assert.That(median, Is.LessThanOrEqualTo(0.1));
            Assert.That(p95, Is.LessThanOrEqualTo(0.3));
        }

        [Test]
        public void TryFind_ReferencePhotographsAskedForAnotherSize_SaysWhatTheyShow()
        {
            foreach ((string name, _) in References())
            {
                Load(name);
                Assert.That(_finder.TryFind(_picture, new BoardSize(8, 6), new Vector2D[48], out string reason), Is.False, name);
                Assert.That(reason, Does.StartWith("9×6 corners found, 8×6 asked for"), name);
            }
        }

        [TestCaseSource(nameof(Clips))]
        public void TryFind_FramesOfAClip_ShowNoBoard(string clip)
        {
            const int width = 640, height = 480, frames = 8;
            byte[] pixels = FfmpegForTests.Run("-i", TestFiles.Reference("clips", clip), "-an", "-vf", $"select=not(mod(n\\,25)),scale={width}:{height}",
                "-fps_mode", "vfr", "-frames:v", $"{frames}", "-f", "rawvideo", "-pix_fmt", "gray", "-");
            Assert.That(pixels, Is.Not.Empty);
            _picture.Reset(PixelFormat.Gray8, width, height, 0);
            for (int start = 0; start < pixels.Length; start += width * height)
            {
                pixels.AsSpan(start, width * height).CopyTo(_picture.Bytes);
                foreach (BoardSize size in new[] { NineBySix, new BoardSize(8, 6), new BoardSize(4, 3), new BoardSize(3, 3) })
                    Assert.That(_finder.TryFind(_picture, size, new Vector2D[size.Count], out _), Is.False, $"{clip} frame {start / (width * height)} {size}");
            }
        }

        private static IEnumerable<string> Clips()
        {
            string folder = Path.Combine(TestFiles.Data, "clips");
            if (!Directory.Exists(folder))
                yield break;
            string[] clips = Directory.GetFiles(folder, "*.mp4");
            Array.Sort(clips, StringComparer.Ordinal);
            foreach (string clip in clips)
                yield return Path.GetFileName(clip);
        }

        private static IEnumerable<(string Name, Vector2D[] Corners)> References()
        {
            JObject stored = JObject.Parse(File.ReadAllText(TestFiles.Reference("stereo", "opencv_9x6", "corners_win5.json")));
            foreach (JToken pair in stored["pairs"]!)
            {
                foreach (string side in new[] { "left", "right" })
                {
                    var corners = new List<Vector2D>();
                    foreach (JToken corner in pair[side + "_px"]!)
                        corners.Add(new Vector2D((double)corner[0]!, (double)corner[1]!));
                    yield return ((string)pair[side]!, corners.ToArray());
                }
            }
        }

        private void Load(string name)
        {
            byte[] jpeg = File.ReadAllBytes(TestFiles.Reference("stereo", "opencv_9x6", name));
            Assert.That(_decoder.TryDecode(jpeg, _picture, 0, out string problem), Is.True, problem);
        }
    }
}
