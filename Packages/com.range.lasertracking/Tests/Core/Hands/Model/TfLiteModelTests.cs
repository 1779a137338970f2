using System;
using NUnit.Framework;

namespace LaserTracking.Hands.Model
{
    /// <summary>A model file that is no model, cut, damaged or another one is refused in one way, and never runs wild.</summary>
    public sealed class TfLiteModelTests
    {
        [Test]
        public void Read_CutAtAnyByte_IsRefusedOrWhole()
        {
            byte[] file = NetworkOperatorTests.SmallNetwork();
            int refused = 0;
            for (int length = 0; length < file.Length; length += length < 64 ? 1 : 7)
                refused += IsRefused(file.AsSpan(0, length).ToArray()) ? 1 : 0;
            Assert.That(refused, Is.GreaterThan(file.Length / 8));
        }

        [Test]
        public void Read_AnyByteChanged_IsRefusedOrRuns()
        {
            byte[] file = NetworkOperatorTests.SmallNetwork();
            var random = new Random(17);
            int refused = 0;
            for (int trial = 0; trial < 1200; trial++)
            {
                var damaged = (byte[])file.Clone();
                for (int i = random.Next(1, 5); i > 0; i--)
                {
                    byte value = (byte)(random.Next(3) == 0 ? 255 : random.Next(256));
                    damaged[random.Next(damaged.Length)] = value;
                }

                refused += IsRefused(damaged) ? 1 : 0;
            }

            Assert.That(refused, Is.GreaterThan(60));
        }

        [TestCase(3, "has a window with gaps", 2)]
        [TestCase(4, "has a window with gaps", 2)]
        public void Read_WindowWithGaps_IsRefused(int code, string words, int dilation)
        {
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 5, 5, 1), to = builder.Tensor(1, 5, 5, 1), w = builder.Constant(new float[9], 1, 3, 3, 1);
            if (code == 3)
                builder.Operator(3, to, new[] { from, w }, (byte)0, 1, 1, (byte)0, dilation, dilation);
            else
                builder.Operator(4, to, new[] { from, w }, (byte)0, 1, 1, 1, (byte)0, dilation, dilation);
            Assert.That(Problem(builder.Build(new[] { from }, to)), Does.Contain(words));
        }

        [Test]
        public void Read_UnknownOperator_IsNamed()
        {
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 4), to = builder.Tensor(1, 4);
            builder.Operator(25, to, new[] { from });
            Assert.That(Problem(builder.Build(new[] { from }, to)), Does.Contain("built-in operator 25"));
        }

        [Test]
        public void Read_OutputOfAnotherSize_IsRefused()
        {
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 5, 5, 1), to = builder.Tensor(1, 5, 4, 1), w = builder.Constant(new float[9], 1, 3, 3, 1);
            builder.Operator(3, to, new[] { from, w }, (byte)0, 1, 1, (byte)0);
            Assert.That(Problem(builder.Build(new[] { from }, to)), Does.Contain("another size"));
        }

        [Test]
        public void Read_TensorThatNothingWrites_IsRefused()
        {
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 4), other = builder.Tensor(1, 4), to = builder.Tensor(1, 4);
            builder.Operator(14, to, new[] { other });
            Assert.That(Problem(builder.Build(new[] { from }, to)), Does.Contain("nothing has written"));
        }

        [Test]
        public void HandLandmarkNetwork_AnotherNetwork_IsRefused()
        {
            InputException? problem = Assert.Throws<InputException>(() => HandLandmarkNetwork.Read(NetworkOperatorTests.SmallNetwork(), "other.tflite"));
            Assert.That(problem!.Message, Does.StartWith("other.tflite: ").And.Contain("something else than hand landmarks"));
        }

        private static string Problem(byte[] file) => Assert.Throws<InputException>(() => Load(file))!.Message;

        private static void Load(byte[] file)
        {
            using var network = new TfLiteNetwork(TfLiteModel.Read(file, "test"), TfLiteNetwork.HasVectors);
            network.Run();
        }

        private static bool IsRefused(byte[] file)
        {
            try
            {
                Load(file);
                return false;
            }
            catch (InputException)
            {
                return true;
            }
        }
    }
}
