using System;
using NUnit.Framework;

namespace LaserTracking.Imaging
{
    public sealed unsafe class JpegInverseDctTests
    {
        [Test]
        public void InverseDct_AnyCoefficients_VectorEqualsScalar()
        {
            var random = new Random(7);
            short* block = stackalloc short[64];
            byte* expected = stackalloc byte[64];
            byte* actual = stackalloc byte[64];
            for (int n = 0; n < 20000; n++)
            {
                // From a few small coefficients, as in real pictures, to nonsense over the whole range.
                int range = 1 << random.Next(1, 16);
                int filled = random.Next(1, 65);
                for (int i = 0; i < 64; i++)
                    block[i] = (short)(random.Next(64) < filled ? random.Next(-range, range) : 0);
                JpegInverseDct.TransformScalar(block, expected);
                JpegInverseDct.Transform(block, actual);
                Assert.That(new Span<byte>(actual, 64).SequenceEqual(new Span<byte>(expected, 64)), Is.True, "block " + n);
            }
        }

        [Test]
        public void InverseDct_RealisticCoefficients_WithinOneOfTheDefinition()
        {
            var random = new Random(3);
            double[,] basis = Basis();
            double[] exact = new double[64];
            short* block = stackalloc short[64];
            byte* samples = stackalloc byte[64];
            double squares = 0;
            const int blocks = 1000;
            for (int n = 0; n < blocks; n++)
            {
                for (int i = 0; i < 64; i++)
                    block[i] = (short)random.Next(-40, 41);
                block[0] = (short)random.Next(-900, 901);
                JpegInverseDct.Transform(block, samples);
                for (int y = 0; y < 8; y++)
                {
                    for (int x = 0; x < 8; x++)
                    {
                        double sum = 128;
                        for (int v = 0; v < 8; v++)
                        {
                            for (int u = 0; u < 8; u++)
                                sum += block[v * 8 + u] * basis[v, y] * basis[u, x];
                        }

                        double difference = samples[y * 8 + x] - Math.Max(0, Math.Min(255, sum));
                        Assert.That(Math.Abs(difference), Is.LessThan(1.0));
                        squares += difference * difference;
                    }
                }
            }

            // Rounding to integers alone costs 1/12.
            Assert.That(squares / (64 * blocks), Is.LessThan(0.1));
        }

        [Test]
        public void InverseDct_DcOnly_EqualsTheFullTransform()
        {
            short* block = stackalloc short[64];
            new Span<short>(block, 64).Clear();
            byte* expected = stackalloc byte[64];
            byte* actual = stackalloc byte[64];
            for (int dc = -2100; dc < 2100; dc++)
            {
                block[0] = (short)dc;
                JpegInverseDct.TransformScalar(block, expected);
                JpegInverseDct.TransformDcOnly(dc, actual);
                Assert.That(new Span<byte>(actual, 64).SequenceEqual(new Span<byte>(expected, 64)), Is.True, "DC " + dc);
            }
        }

        [Test]
        public void ForwardDct_ThenInverse_ReturnsTheSamples()
        {
            var random = new Random(5);
            int* forward = stackalloc int[64];
            short* block = stackalloc short[64];
            byte* samples = stackalloc byte[64];
            byte[] original = new byte[64];
            for (int n = 0; n < 1000; n++)
            {
                random.NextBytes(original);
                for (int i = 0; i < 64; i++)
                    forward[i] = original[i] - 128;
                JpegForwardDct.Transform(forward);
                for (int i = 0; i < 64; i++)
                    block[i] = (short)Math.Round(forward[i] / 8.0);
                JpegInverseDct.Transform(block, samples);
                for (int i = 0; i < 64; i++)
                    Assert.That(Math.Abs(samples[i] - original[i]), Is.LessThanOrEqualTo(2));
            }
        }

        private static double[,] Basis()
        {
            var basis = new double[8, 8];
            for (int u = 0; u < 8; u++)
            {
                for (int x = 0; x < 8; x++)
                    basis[u, x] = 0.5 * (u == 0 ? Math.Sqrt(0.5) : 1) * Math.Cos((2 * x + 1) * u * Math.PI / 16);
            }

            return basis;
        }
    }
}
