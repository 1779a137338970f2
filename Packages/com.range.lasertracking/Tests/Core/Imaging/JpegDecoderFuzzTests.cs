using System;
using System.Collections.Generic;
using System.Diagnostics;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    public sealed class JpegDecoderFuzzTests
    {
        private const int Mutations = 24000;

        [Test]
        public void TryDecode_MutatedPictures_NeverThrowsNorHangs()
        {
            var random = new Random(20);
            List<byte[]> seeds = Seeds();
            var decoder = new JpegDecoder();
            int decoded = 0;
            long slowest = 0;
            using (var target = new Image())
            {
                for (int n = 0; n < Mutations; n++)
                {
                    byte[] mutated = Mutate(seeds[n % seeds.Count], random);
                    long start = Stopwatch.GetTimestamp();
                    bool success = decoder.TryDecode(mutated, target, n, out string problem);
                    slowest = Math.Max(slowest, Stopwatch.GetTimestamp() - start);
                    if (success)
                        decoded++;
                    if (success != target.IsPresent || success != (problem.Length == 0) || problem.IndexOf('\n') >= 0)
                        Assert.Fail("mutation " + n + ": result, picture and problem contradict each other: " + problem);
                }
            }

            Assert.That(slowest, Is.LessThan(Stopwatch.Frequency), "one picture took over a second");
            Assert.That(decoded, Is.GreaterThan(Mutations / 100), "the mutations are too wild to reach the decoder");
            Assert.That(decoded, Is.LessThan(Mutations * 9 / 10));
        }

        private static List<byte[]> Seeds()
        {
            var seeds = new List<byte[]>();
            using (var source = new Image())
            {
                TestPictures.Fill(source, PixelFormat.Yuy2, 70, 37, 2);
                seeds.Add(new JpegEncoder(80, 3).Encode(source).ToArray());
                seeds.Add(new JpegEncoder(60, 0, false).Encode(source).ToArray());
                TestPictures.Fill(source, PixelFormat.Nv12, 66, 38, 3);
                seeds.Add(new JpegEncoder(80).Encode(source).ToArray());
                TestPictures.Fill(source, PixelFormat.Gray8, 45, 33, 4);
                seeds.Add(new JpegEncoder(40, 2).Encode(source).ToArray());
                TestPictures.Fill(source, PixelFormat.Bgra32, 35, 20, 5);
                seeds.Add(new JpegEncoder(90).Encode(source).ToArray());
            }

            return seeds;
        }

        private static byte[] Mutate(byte[] seed, Random random)
        {
            byte[] result = (byte[])seed.Clone();
            int header = JpegDecoderTests.FindSegment(seed, 0xDA) + 14;
            int changes = 1 + random.Next(4);
            for (int i = 0; i < changes; i++)
            {
                // Half of the changes go to the header, whose few bytes decide most.
                int at = random.Next(2) == 0 ? random.Next(header) : random.Next(result.Length);
                switch (random.Next(5))
                {
                    case 0:
                        result[at] = (byte)random.Next(256);
                        break;
                    case 1:
                        result[at] ^= (byte)(1 << random.Next(8));
                        break;
                    case 2:
                        result[at] = 0xFF;
                        break;
                    case 3:
                        Array.Resize(ref result, Math.Max(1, result.Length - random.Next(result.Length / 4)));
                        header = Math.Min(header, result.Length);
                        break;
                    default:
                        int count = Math.Min(random.Next(1, 40), result.Length - at);
                        Array.Copy(result, random.Next(result.Length - count + 1), result, at, count);
                        break;
                }
            }

            return result;
        }
    }
}
