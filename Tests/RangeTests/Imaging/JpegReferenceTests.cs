using System;
using System.Collections.Generic;
using System.IO;
using System.Security.Cryptography;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    /// <summary>The JPEG decoder beside FFmpeg's and beside the conversion of the Azure Kinect library.</summary>
    [Category("Reference")]
    public sealed class JpegReferenceTests
    {
        private readonly JpegDecoder _decoder = new();

        private static IEnumerable<string> Recordings()
        {
            string folder = Path.Combine(TestFiles.Data, "k4a");
            if (!Directory.Exists(folder))
                yield break;
            string[] references = Directory.GetFiles(folder, "rec_*.reference.json");
            Array.Sort(references, StringComparer.Ordinal);
            foreach (string reference in references)
            {
                if ((string?)JObject.Parse(File.ReadAllText(reference))["record_configuration"]?["color_format"] == "COLOR_MJPG")
                    yield return Path.GetFileName(reference).Replace(".reference.json", "");
            }
        }

        [TestCaseSource(nameof(Recordings))]
        public void TryDecode_EveryRecordedFrame_HasThePlanesThatFfmpegSees(string recording)
        {
            using var folder = new TemporaryFolder();
            List<byte[]> frames = ExtractFrames(recording, folder.Path);
            using var decoded = new Image();
            Assert.That(_decoder.TryDecode(frames[0], decoded, 0, out string problem), Is.True, problem);
            string layout = decoded.Format == PixelFormat.Yuy2 ? "yuvj422p" : "yuvj420p";
            string rawPath = folder.File("all.raw");
            FfmpegForTests.Run("-idct", "int", "-i", folder.File("%05d.jpg"), "-pix_fmt", layout, "-f", "rawvideo", rawPath);
            using FileStream raw = File.OpenRead(rawPath);
            byte[] expected = new byte[decoded.SizeBytes];
            for (int i = 0; i < frames.Count; i++)
            {
                Assert.That(_decoder.TryDecode(frames[i], decoded, 0, out problem), Is.True, problem);
                raw.ReadExactly(expected);
                AssertNear(Planes(decoded), expected, 1, 0.02, recording + " frame " + i);
            }

            Assert.That(raw.Position, Is.EqualTo(raw.Length));
        }

        [TestCaseSource(nameof(Recordings))]
        public void TryDecode_ThenToBgra_IsWithinAFewCountsOfTheLibrary(string recording)
        {
            using var folder = new TemporaryFolder();
            List<byte[]> frames = ExtractFrames(recording, folder.Path);
            JToken reference = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", recording + ".reference.json")));
            List<int> colorFrames = ColorFrames(reference);
            using var decoded = new Image();
            using var bgra = new Image();
            int compared = 0;
            long sum = 0;
            foreach (JToken capture in reference["color_converted_to_bgra_samples"]!["captures"]!)
            {
                Assert.That(_decoder.TryDecode(frames[colorFrames.IndexOf((int)capture["capture"]!)], decoded, 0, out string problem), problem);
                ColorConversion.ToBgra(decoded, bgra);
                foreach (JToken sample in capture["bgra"]!)
                {
                    int at = (int)sample[1]! * bgra.Stride + (int)sample[0]! * 4;
                    for (int c = 0; c < 3; c++, compared++)
                    {
                        int difference = Math.Abs(bgra.Bytes[at + c] - (int)sample[2 + c]!);
                        sum += difference;
                        Assert.That(difference, Is.LessThanOrEqualTo(4), $"capture {capture["capture"]} sample {sample}");
                    }
                }
            }

            Assert.That(compared, Is.GreaterThan(0));
            // The library asks libjpeg for its fast transform, which cuts fractions off where the accurate one rounds.
            Assert.That((double)sum / compared, Is.LessThan(1.5));
        }

        [TestCase("yuvj422p", 202, 118, 2, PixelFormat.Yuy2)]
        [TestCase("yuvj422p", 1280, 720, 12, PixelFormat.Yuy2)]
        [TestCase("yuvj420p", 202, 118, 5, PixelFormat.Nv12)]
        [TestCase("yuvj420p", 640, 480, 25, PixelFormat.Nv12)]
        [TestCase("yuvj420p", 203, 117, 5, PixelFormat.Bgra32)]
        [TestCase("yuvj444p", 203, 117, 3, PixelFormat.Bgra32)]
        [TestCase("yuvj422p", 203, 117, 3, PixelFormat.Bgra32)]
        public void TryDecode_PicturesOfFfmpeg_HaveItsPlanes(string layout, int width, int height, int quality, PixelFormat format)
        {
            using var folder = new TemporaryFolder();
            string path = Path.Combine(folder.Path, "picture.jpg");
            FfmpegForTests.Run("-f", "lavfi", "-i", $"testsrc2=size={width + 1}x{height + 1}:rate=1", "-frames:v", "1", "-vf",
                $"noise=alls=9:all_seed=3,format=yuv444p,crop={width}:{height}:0:0:exact=1,format={layout}", "-q:v", quality.ToString(), path);
            using var decoded = new Image();
            Assert.That(_decoder.TryDecode(File.ReadAllBytes(path), decoded, 0, out string problem), Is.True, problem);
            Assert.That(decoded.Format, Is.EqualTo(format));
            Assert.That((decoded.Width, decoded.Height), Is.EqualTo((width, height)));

            // FFmpeg's "int" transform is the same flow graph with other roundings.
            byte[] expected = FfmpegForTests.Run("-idct", "int", "-i", path, "-pix_fmt", layout, "-f", "rawvideo", "-");
            if (format == PixelFormat.Bgra32)
                AssertNear(Planes(decoded), ToBgr(expected, layout, width, height), 3, 0.1, layout);
            else
                AssertNear(Planes(decoded), expected, 1, 0.05, layout);
        }

        private static void AssertNear(byte[] actual, byte[] expected, int limit, double meanLimit, string what)
        {
            Assert.That(actual, Has.Length.EqualTo(expected.Length), what);
            int worst = 0;
            long sum = 0;
            for (int i = 0; i < actual.Length; i++)
            {
                int difference = Math.Abs(actual[i] - expected[i]);
                worst = Math.Max(worst, difference);
                sum += difference;
            }

            Assert.That(worst, Is.LessThanOrEqualTo(limit), what);
            Assert.That((double)sum / actual.Length, Is.LessThan(meanLimit), what);
        }

        /// <summary>Y, U and V (or B, G and R) one after the other.</summary>
        private static byte[] Planes(Image image)
        {
            ReadOnlySpan<byte> pixels = image.Bytes;
            int count = image.Width * image.Height;
            byte[] planes = new byte[image.Format == PixelFormat.Bgra32 ? count * 3 : image.SizeBytes];
            switch (image.Format)
            {
                case PixelFormat.Yuy2:
                    Take(pixels, 0, 2, planes.AsSpan(0, count));
                    Take(pixels, 1, 4, planes.AsSpan(count, count / 2));
                    Take(pixels, 3, 4, planes.AsSpan(count + count / 2));
                    break;
                case PixelFormat.Nv12:
                    Take(pixels, 0, 1, planes.AsSpan(0, count));
                    Take(pixels, count, 2, planes.AsSpan(count, count / 4));
                    Take(pixels, count + 1, 2, planes.AsSpan(count + count / 4));
                    break;
                default:
                    for (int c = 0; c < 3; c++)
                        Take(pixels, c, 4, planes.AsSpan(c * count, count));
                    break;
            }

            return planes;
        }

        private static void Take(ReadOnlySpan<byte> pixels, int start, int step, Span<byte> plane)
        {
            for (int i = 0; i < plane.Length; i++)
                plane[i] = pixels[start + i * step];
        }

        /// <summary>JFIF's equations in floating point; chroma is repeated.</summary>
        private static byte[] ToBgr(byte[] yuv, string layout, int width, int height)
        {
            int acrossShift = layout == "yuvj444p" ? 0 : 1;
            int downShift = layout == "yuvj420p" ? 1 : 0;
            int chromaWidth = (width + acrossShift) >> acrossShift;
            int chromaHeight = (height + downShift) >> downShift;
            int count = width * height;
            byte[] bgr = new byte[count * 3];
            for (int i = 0; i < count; i++)
            {
                int chroma = count + (i / width >> downShift) * chromaWidth + (i % width >> acrossShift);
                double u = yuv[chroma] - 128;
                double v = yuv[chroma + chromaWidth * chromaHeight] - 128;
                bgr[i] = Round(yuv[i] + 1.772 * u);
                bgr[count + i] = Round(yuv[i] - 0.344136 * u - 0.714136 * v);
                bgr[2 * count + i] = Round(yuv[i] + 1.402 * v);
            }

            return bgr;
        }

        private static byte Round(double value) => (byte)Math.Clamp(Math.Round(value), 0, 255);

        /// <summary>The payloads as recorded; that they are the right ones is checked by the hashes of the reference.</summary>
        private static List<byte[]> ExtractFrames(string recording, string folder)
        {
            FfmpegForTests.Run("-i", TestFiles.Reference("k4a", recording + ".mkv"), "-map", "0:v:0", "-c", "copy", "-f", "image2",
                Path.Combine(folder, "%05d.jpg"));
            string[] files = Directory.GetFiles(folder, "*.jpg");
            Array.Sort(files, StringComparer.Ordinal);
            JToken reference = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", recording + ".reference.json")));
            List<int> colorFrames = ColorFrames(reference);
            var frames = new List<byte[]>();
            for (int i = 0; i < files.Length; i++)
            {
                frames.Add(File.ReadAllBytes(files[i]));
                string expected = (string)reference["captures"]![colorFrames[i]]!["color"]!["sha256"]!;
                Assert.That(Convert.ToHexStringLower(SHA256.HashData(frames[i])), Is.EqualTo(expected));
            }

            Assert.That(frames, Has.Count.EqualTo(colorFrames.Count));
            return frames;
        }

        /// <summary>Indices of the captures that have a colour picture.</summary>
        private static List<int> ColorFrames(JToken reference)
        {
            var indices = new List<int>();
            int index = 0;
            foreach (JToken capture in reference["captures"]!)
            {
                if (capture["color"]!.HasValues)
                    indices.Add(index);
                index++;
            }

            return indices;
        }
    }
}
