using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>The published algorithm's kernels: vector against scalar over odd sizes, and the whole detector with and without.</summary>
    public sealed unsafe class PaperKernelTests
    {
        private static readonly int[] Widths = { 1, 2, 3, 7, 8, 9, 10, 15, 16, 17, 31, 33, 64, 65 };

        [Test]
        public void Reduce_VectorAndScalar_AreEqualAndTheMeanOfTheirPixels()
        {
            var random = new Random(3);
            foreach (int width in Widths)
            {
                int stride = (2 * width + 5) * 4;
                var pixels = new byte[2 * stride];
                random.NextBytes(pixels);
                var edges = new int[width + 1];
                for (int i = 0; i <= width; i++)
                    edges[i] = 2 * i;
                float[] a = new float[width], b = new float[width], c = new float[width], d = new float[width];
                fixed (byte* p = pixels)
                fixed (int* e = edges)
                fixed (float* pa = a, pb = b, pc = c, pd = d)
                {
                    PaperKernel.Reduce(p, 2, stride, e, width, pa, pb, false);
                    PaperKernel.Reduce(p, 2, stride, e, width, pc, pd, true);
                }

                Assert.That(c, Is.EqualTo(a), "intensity, width " + width);
                Assert.That(d, Is.EqualTo(b), "excess, width " + width);
                double green = (pixels[1] + pixels[5] + pixels[stride + 1] + pixels[stride + 5]) / 4.0;
                double others = (pixels[0] + pixels[4] + pixels[stride] + pixels[stride + 4] + pixels[2] + pixels[6] + pixels[stride + 2] + pixels[stride + 6]) / 8.0;
                Assert.That(a.Length > 0 ? b[0] : 0, Is.EqualTo(Math.Max(0, green - others)).Within(1e-4));
            }
        }

        [Test]
        public void RowKernels_VectorAndScalar_AreEqual()
        {
            var random = new Random(4);
            foreach (int width in Widths)
            {
                var results = new List<float[]>();
                foreach (bool useVectors in new[] { false, true })
                {
                    random = new Random(width);
                    float[] x = Row(random, width), y = Row(random, width), z = Row(random, width), target = new float[width], other = new float[width], score = new float[width];
                    fixed (float* px = x, py = y, pz = z, t = target, o = other, s = score)
                    {
                        PaperKernel.Differ(px, py, py, width, 0.95f, t, useVectors);
                        PaperKernel.BlurRow(t, width, o, useVectors);
                        PaperKernel.BlurColumns(px, o, py, width, t, useVectors);
                        PaperKernel.Score(t, o, pz, width, 0.88f, 0.6f, 0.4f, s, useVectors);
                        int found = PaperKernel.FindCandidate(s, o, width / 3, width, 80, 25, 90, useVectors);
                        results.Add(new float[] { found });
                    }

                    results.AddRange(new[] { y, z, target, other, score });
                }

                for (int i = 0; i < results.Count / 2; i++)
                    Assert.That(results[i + results.Count / 2], Is.EqualTo(results[i]), "width " + width + " result " + i);
            }
        }

        [TestCase(PixelFormat.Bgra32)]
        [TestCase(PixelFormat.Nv12)]
        [TestCase(PixelFormat.Yuy2)]
        public void Process_WithAndWithoutVectors_FindsTheSame(PixelFormat format)
        {
            var results = new List<string>();
            foreach (bool useVectors in new[] { false, true })
            {
                var run = new DetectionRun(new PaperShotDetector(new PaperDetectorSettings { UseVectors = useVectors, ReducedWidthPx = 160 })) { Format = format };
                run.Play(0, 8, (b, i) => b.Wall(30, 30, 30));
                run.Play(8, 3, (b, i) => b.Wall(30, 30, 30).Dot(151.3 + i, 97.6, 3, 20, 200, 20));
                string text = run.Shots.Count + ": ";
                foreach (Dot dot in run.Detections.Dots)
                    text += dot.PositionPx + " " + dot.Confidence.ToString("R");
                results.Add(text);
            }

            Assert.That(results[1], Is.EqualTo(results[0]));
            Assert.That(results[0], Does.Not.StartWith("0"));
        }

        [Test]
        public void Threshold_BrighterScene_FollowsItsIntensity()
        {
            double Threshold(float level)
            {
                var detector = new PaperShotDetector();
                var run = new DetectionRun(detector);
                run.Builder.NoiseSigma = 0;

                // A fifth of the picture is greenish and moves, so that scores are spread.
                run.Play(0, 6, (b, i) => b.Wall(level, level, level).Box(20 * i, 40, 120, 80, level * 0.5f, level * 2, level * 0.5f));
                return detector.Threshold;
            }

            double dim = Threshold(25), bright = Threshold(50), brightest = Threshold(100);
            Assert.That(dim, Is.GreaterThan(1));
            Assert.That(bright, Is.EqualTo(2 * dim).Within(0.05 * bright + 0.2));
            Assert.That(brightest, Is.EqualTo(4 * dim).Within(0.05 * brightest + 0.4));
        }

        [Test]
        public void Process_WarmFrameLoop_AllocatesNothing()
        {
            var run = new DetectionRun(new PaperShotDetector());
            run.Play(0, 4, (b, i) => b.Wall(30, 30, 30).GreenDot(150, 100));
            Frame frame = run.Frame;
            Assert.That(Allocation.Of(() => run.Detector.Process(frame, run.Detections)), Is.Zero);
        }

        private static float[] Row(Random random, int width)
        {
            var row = new float[width];
            for (int i = 0; i < width; i++)
                row[i] = (float)(random.NextDouble() * 255);
            return row;
        }
    }
}
