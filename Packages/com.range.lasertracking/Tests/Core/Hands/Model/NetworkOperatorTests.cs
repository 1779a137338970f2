using System;
using System.Collections.Generic;
using NUnit.Framework;

namespace LaserTracking.Hands.Model
{
    /// <summary>Each operator, in both forms of its kernel, against straightforward loops in double precision.</summary>
    public sealed class NetworkOperatorTests
    {
        private const float Tolerance = 2e-5f;

        private static IEnumerable<TestCaseData> Windows()
        {
            // height, width, channels, outputs, window, stride, same, activation
            yield return new TestCaseData(7, 5, 3, 24, 3, 2, true, 3);
            yield return new TestCaseData(8, 8, 3, 24, 3, 2, true, 3);
            yield return new TestCaseData(5, 6, 4, 7, 3, 1, true, 0);
            yield return new TestCaseData(6, 9, 2, 17, 3, 2, false, 1);
            yield return new TestCaseData(1, 1, 33, 63, 1, 1, true, 0);
            yield return new TestCaseData(7, 7, 16, 40, 1, 1, false, 3);
            yield return new TestCaseData(9, 3, 19, 8, 1, 1, true, 0);
            yield return new TestCaseData(4, 4, 5, 16, 1, 2, true, 0);
            yield return new TestCaseData(2, 2, 8, 8, 5, 2, true, 0);
        }

        private static IEnumerable<TestCaseData> DepthwiseWindows()
        {
            yield return new TestCaseData(9, 9, 24, 3, 1, true, 3);
            yield return new TestCaseData(8, 8, 16, 3, 2, true, 3);
            yield return new TestCaseData(8, 8, 40, 5, 2, true, 3);
            yield return new TestCaseData(7, 7, 72, 5, 1, true, 0);
            yield return new TestCaseData(11, 6, 13, 3, 2, true, 1);
            yield return new TestCaseData(6, 11, 3, 5, 2, false, 0);
            yield return new TestCaseData(2, 3, 8, 5, 1, true, 0);
            yield return new TestCaseData(1, 1, 9, 3, 2, true, 0);
        }

        [TestCaseSource(nameof(Windows))]
        public void Convolution_AnyWindow_IsTheSumOverIt(int height, int width, int channels, int outputs, int window, int stride, bool same, int activation)
        {
            var random = new Random(height * 31 + outputs);
            float[] weights = Values(random, outputs * window * window * channels), bias = Values(random, outputs), input = Values(random, height * width * channels);
            int outHeight = Side(height, window, stride, same), outWidth = Side(width, window, stride, same);
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, height, width, channels), to = builder.Tensor(1, outHeight, outWidth, outputs);
            int w = builder.Constant(weights, outputs, window, window, channels), b = builder.Constant(bias, outputs);
            builder.Operator(3, to, new[] { from, w, b }, (byte)(same ? 0 : 1), stride, stride, (byte)activation);
            AssertRuns(builder.Build(new[] { from }, to), input, (y, x, o) =>
            {
                double sum = bias[o];
                ForWindow(y, x, height, width, window, stride, same, (iy, ix, ky, kx) =>
                {
                    for (int c = 0; c < channels; c++)
                        sum += (double)input[(iy * width + ix) * channels + c] * weights[((o * window + ky) * window + kx) * channels + c];
                });
                return Activate(sum, activation);
            }, outHeight, outWidth, outputs);
        }

        [TestCaseSource(nameof(DepthwiseWindows))]
        public void Depthwise_AnyWindow_IsTheSumOverItInEachChannel(int height, int width, int channels, int window, int stride, bool same, int activation)
        {
            var random = new Random(height * 37 + channels);
            float[] weights = Values(random, window * window * channels), bias = Values(random, channels), input = Values(random, height * width * channels);
            int outHeight = Side(height, window, stride, same), outWidth = Side(width, window, stride, same);
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, height, width, channels), to = builder.Tensor(1, outHeight, outWidth, channels);
            int w = builder.Constant(weights, 1, window, window, channels), b = builder.Constant(bias, channels);
            builder.Operator(4, to, new[] { from, w, b }, (byte)(same ? 0 : 1), stride, stride, 1, (byte)activation);
            AssertRuns(builder.Build(new[] { from }, to), input, (y, x, c) =>
            {
                double sum = bias[c];
                ForWindow(y, x, height, width, window, stride, same, (iy, ix, ky, kx) =>
                    sum += (double)input[(iy * width + ix) * channels + c] * weights[(ky * window + kx) * channels + c]);
                return Activate(sum, activation);
            }, outHeight, outWidth, channels);
        }

        [TestCase(6, 6, 5, 2, 2, false)]
        [TestCase(7, 5, 3, 3, 2, true)]
        public void MaxPool_AnyWindow_IsItsLargestValue(int height, int width, int channels, int window, int stride, bool same)
        {
            float[] input = Values(new Random(5), height * width * channels);
            int outHeight = Side(height, window, stride, same), outWidth = Side(width, window, stride, same);
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, height, width, channels), to = builder.Tensor(1, outHeight, outWidth, channels);
            builder.Operator(17, to, new[] { from }, (byte)(same ? 0 : 1), stride, stride, window, window, (byte)0);
            AssertRuns(builder.Build(new[] { from }, to), input, (y, x, c) =>
            {
                double largest = double.NegativeInfinity;
                ForWindow(y, x, height, width, window, stride, same, (iy, ix, ky, kx) => largest = Math.Max(largest, input[(iy * width + ix) * channels + c]));
                return largest;
            }, outHeight, outWidth, channels);
        }

        [Test]
        public void Chain_AddMeanFullyConnectedLogistic_IsTheFormula()
        {
            const int channels = 21;
            var random = new Random(3);
            float[] input = Values(random, 3 * 4 * channels), weights = Values(random, 2 * channels), bias = Values(random, 2);
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 3, 4, channels), sum = builder.Tensor(1, 3, 4, channels), mean = builder.Tensor(1, channels);
            int linear = builder.Tensor(1, 2), to = builder.Tensor(1, 2);
            int axes = builder.Integers(new[] { 1, 2 }, 2), w = builder.Constant(weights, 2, channels), b = builder.Constant(bias, 2);
            builder.Operator(0, sum, new[] { from, from }, (byte)3);
            builder.Operator(40, mean, new[] { sum, axes }, (byte)0);
            builder.Operator(9, linear, new[] { mean, w, b }, (byte)0, (byte)0);
            builder.Operator(14, to, new[] { linear });
            AssertRuns(builder.Build(new[] { from }, to), input, (y, x, o) =>
            {
                double value = bias[o];
                for (int i = 0; i < input.Length; i++)
                    value += Activate(2.0 * input[i], 3) / 12 * weights[o * channels + i % channels];
                return 1 / (1 + Math.Exp(-value));
            }, 1, 1, 2);
        }

        [Test]
        public void Dequantize_HalvesOfEveryKind_AreTheSameNumbers()
        {
            // 1, -2, 65504 (largest), 2^-24 (smallest), -0, 1/3 rounded, 2^-14 (smallest normal), 0.
            var halves = new ushort[] { 0x3C00, 0xC000, 0x7BFF, 0x0001, 0x8000, 0x3555, 0x0400, 0x0000 };
            var expected = new[] { 1f, -2f, 65504f, 1f / (1 << 24), 0f, 0.333251953125f, 1f / (1 << 14), 0f };
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 1), to = builder.Tensor(1, 8), packed = builder.Halves(halves, 8, 1), w = builder.Tensor(8, 1);
            builder.Operator(6, w, new[] { packed });
            builder.Operator(9, to, new[] { from, w, -1 }, (byte)0);
            AssertRuns(builder.Build(new[] { from }, to), new[] { 1f }, (y, x, o) => expected[o], 1, 1, 8);
        }

        [Test]
        public void Run_Warm_AllocatesNothing()
        {
            using var network = new TfLiteNetwork(TfLiteModel.Read(SmallNetwork(), "test"), TfLiteNetwork.HasVectors);
            Assert.That(Allocation.Of(network.Run), Is.Zero);
        }

        [Test]
        public void Run_Again_GivesTheSameBytes()
        {
            using var network = new TfLiteNetwork(TfLiteModel.Read(SmallNetwork(), "test"), TfLiteNetwork.HasVectors);
            network.Run();
            float[] first = Copy(network.Outputs[0]);
            network.Run();
            Assert.That(Copy(network.Outputs[0]), Is.EqualTo(first));
        }

        /// <summary>An inverted residual block as in the hand models, with its memory used again.</summary>
        internal static byte[] SmallNetwork()
        {
            var random = new Random(11);
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 8, 8, 8), wide = builder.Tensor(1, 8, 8, 24), deep = builder.Tensor(1, 8, 8, 24);
            int narrow = builder.Tensor(1, 8, 8, 8), to = builder.Tensor(1, 8, 8, 8);
            builder.Operator(3, wide, new[] { from, builder.Constant(Values(random, 24 * 8), 24, 1, 1, 8), builder.Constant(Values(random, 24), 24) }, (byte)0, 1, 1, (byte)3);
            builder.Operator(4, deep, new[] { wide, builder.Constant(Values(random, 9 * 24), 1, 3, 3, 24), builder.Constant(Values(random, 24), 24) }, (byte)0, 1, 1, 1, (byte)3);
            builder.Operator(3, narrow, new[] { deep, builder.Constant(Values(random, 24 * 8), 8, 1, 1, 24), builder.Constant(Values(random, 8), 8) }, (byte)0, 1, 1, (byte)0);
            builder.Operator(0, to, new[] { narrow, from }, (byte)0);
            return builder.Build(new[] { from }, to);
        }

        private static unsafe float[] Copy(FeatureMap map) => new ReadOnlySpan<float>(map.Data, map.Count).ToArray();

        private static unsafe void AssertRuns(byte[] file, float[] input, Func<int, int, int, double> expected, int height, int width, int channels)
        {
            foreach (bool useVectors in TfLiteNetwork.HasVectors ? new[] { false, true } : new[] { false })
            {
                using var network = new TfLiteNetwork(TfLiteModel.Read(file, "test"), useVectors);
                input.CopyTo(new Span<float>(network.Inputs[0].Data, input.Length));

                // Twice: what a run leaves in its buffers must not show in the next.
                network.Run();
                network.Run();
                float[] found = Copy(network.Outputs[0]);
                Assert.That(found, Has.Length.EqualTo(height * width * channels));
                for (int y = 0; y < height; y++)
                {
                    for (int x = 0; x < width; x++)
                    {
                        for (int c = 0; c < channels; c++)
                        {
                            double value = expected(y, x, c);
                            Assert.That(found[(y * width + x) * channels + c], Is.EqualTo(value).Within(Tolerance * Math.Max(1, Math.Abs(value))), $"row {y}, column {x}, channel {c}, vectors {useVectors}");
                        }
                    }
                }
            }
        }

        /// <summary>Padding "same" by its definition: as little as gives ⌈side/stride⌉ outputs, the odd one behind.</summary>
        private static void ForWindow(int y, int x, int height, int width, int window, int stride, bool same, Action<int, int, int, int> visit)
        {
            int above = same ? Math.Max(0, (Side(height, window, stride, true) - 1) * stride + window - height) / 2 : 0;
            int left = same ? Math.Max(0, (Side(width, window, stride, true) - 1) * stride + window - width) / 2 : 0;
            for (int ky = 0; ky < window; ky++)
            {
                for (int kx = 0; kx < window; kx++)
                {
                    int iy = y * stride + ky - above, ix = x * stride + kx - left;
                    if (iy >= 0 && iy < height && ix >= 0 && ix < width)
                        visit(iy, ix, ky, kx);
                }
            }
        }

        private static int Side(int side, int window, int stride, bool same) => same ? (side + stride - 1) / stride : (side - window) / stride + 1;

        private static double Activate(double value, int activation) => activation == 0 ? value : Math.Max(0, activation == 3 ? Math.Min(6, value) : value);

        private static float[] Values(Random random, int count)
        {
            var values = new float[count];
            for (int i = 0; i < count; i++)
                values[i] = (float)(2 * random.NextDouble() - 1);
            return values;
        }
    }
}
