using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Imaging;
using LaserTracking.Kernels;
using LaserTracking.Simulation;
using NUnit.Framework;
using UnityStandIn;

namespace LaserTracking.Burst
{
    /// <summary>Whole detectors and trackers over a simulated range: what they find with jobs is, bit for bit, what they find without.</summary>
    public sealed class SimulatedFrameTests
    {
        [TestCase(PixelFormat.Bgra32, 322, 178)]
        [TestCase(PixelFormat.Nv12, 326, 182)]
        [TestCase(PixelFormat.Yuy2, 330, 180)]
        public void ShotDetector_ThatKnowsTheRenderedPictures_FindsTheSameWithJobs(PixelFormat format, int width, int height)
        {
            var range = new SimulatedRange(Scenario(format, width, height), SimulationScenes.Empty());
            List<Frame> frames = Record(range.CreateColorSource()), pictures = Record(range.CreatePictureSource());
            AssertSame(kernels => PlayKnown(range, frames, pictures, kernels), "PlaneJob", "ExpectationJob", "ComparisonJob");
        }

        [Test]
        public void ShotDetector_WhileANoisyCameraIsKnocked_FindsTheSameWithJobs()
        {
            SimulationScenario scenario = Scenario(PixelFormat.Bgra32, 322, 242);
            scenario.Nudges.Add(new NudgeSettings { TimeS = 0.7, ShiftPx = new Vector2D(2.4, -1.5) });
            List<Frame> frames = Record(scenario);
            AssertSame(kernels => Play(frames, new ShotDetector(new ShotDetectorSettings { SmoothingNoise = 0.5 }, null, kernels)), "PlaneJob", "DilationJob", "PatchJob", "PatchMatchJob", "RatioJob", "HistogramJob", "RiseJob");
        }

        [Test]
        public void ShotDetector_WhileTheExposureChanges_FindsTheSameWithJobs()
        {
            List<Frame> frames = Record(Scenario(PixelFormat.Bgra32, 322, 242));
            foreach (Frame frame in frames.Skip(20))
            {
                foreach (ref byte level in frame.Color.Bytes)
                    level = (byte)(level * 3 / 4);
            }

            AssertSame(kernels => Play(frames, new ShotDetector(null, null, kernels)), "RescaleJob");
        }

        [TestCase(PixelFormat.Bgra32)]
        [TestCase(PixelFormat.Gray8)]
        public void ShotDetector_PictureOfOddSize_FindsTheSameWithJobs(PixelFormat format)
        {
            List<Frame> frames = Draw(format);
            AssertSame(kernels => Play(frames, new ShotDetector(new ShotDetectorSettings { FullSizeMaxWidthPx = 200 }, null, kernels)), "PlaneJob");
        }

        [Test]
        public void PaperShotDetector_FindsTheSameWithJobs()
        {
            List<Frame> frames = Record(Scenario(PixelFormat.Nv12, 326, 182));
            AssertSame(kernels => Play(frames, new PaperShotDetector(new PaperDetectorSettings { ReducedWidthPx = 161 }, kernels)), "PaperJob");
        }

        [Test]
        public void DualShotDetector_FindsTheSameWithJobs()
        {
            SimulationScenario scenario = Scenario(PixelFormat.Yuy2, 330, 180);
            scenario.InfraredCamera.Enabled = true;
            scenario.InfraredCamera.Width = scenario.InfraredCamera.Height = 250;
            List<Frame> frames = Record(scenario);
            AssertSame(kernels => Play(frames, new DualShotDetector(null, null, null, kernels)), "PlaneJob", "InfraredTileJob", "GreenTileJob");
        }

        [Test]
        public void DepthHandTracker_FindsTheSameWithJobs()
        {
            var scenario = new SimulationScenario { Seed = 5, DurationS = 0.5 };
            scenario.DepthCamera.Binned = true;
            scenario.Shooters.Add(new ShooterSettings());
            var range = new SimulatedRange(scenario, SimulationScenes.Empty());
            List<Frame> frames = Record(range.CreateDepthSource());
            AssertSame(kernels => PlayHands(range, frames, kernels), "DepthGridJob", "BridgeJob", "DepthLevelJob", "SurfaceJob", "TorsoJob");
        }

        [Test]
        public void HandModel_OfAllItsOperators_AnswersTheSameWithJobs([Values] bool isInfrared)
        {
            byte[] file = Network();
            using Image picture = DetectionCases.RandomImage(new Random(3), isInfrared ? PixelFormat.Infrared16 : PixelFormat.Nv12);
            string[] used = { "CropJob", "ConvolutionJob", "DepthwiseJob", "AddJob", "MaxPoolJob" };
            AssertSame(kernels => Look(file, picture, kernels), isInfrared ? used.Append("ExposureJob").ToArray() : used);
        }

        private static void AssertSame(Func<KernelRunner, byte[]> play, params string[] jobs)
        {
            byte[] plain = play(KernelRunner.Plain);
            Assert.That(plain, Is.Not.Empty, "something was found");
            foreach (JobOrder order in new[] { JobOrder.Scrambled, JobOrder.Parallel })
            {
                JobWorkers.Reset(order, 6);
                Assert.That(play(new BurstKernelRunner()).AsSpan().SequenceEqual(plain), Is.True, order.ToString());
                Assert.That(jobs.Except(JobWorkers.Runs.Keys), Is.Empty, "jobs that did not run");
            }
        }

        private static SimulationScenario Scenario(PixelFormat format, int width, int height)
        {
            var scenario = new SimulationScenario { Seed = 7, DurationS = 2 };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Format = format;
            scenario.ColorCamera.Width = width;
            scenario.ColorCamera.Height = height;
            scenario.Projector.Width = 320;
            scenario.Projector.Height = 180;
            scenario.Projector.Content = ProjectedContent.Shapes;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shooters[0].Laser.DotRadiusMm = 8;
            scenario.Shots.Add(new ShotSettings { TimeS = 1.2, ScreenM = new Vector2D(1.1, 0.8) });
            scenario.Shots.Add(new ShotSettings { TimeS = 1.7, ScreenM = new Vector2D(2.3, 1.1) });
            return scenario;
        }

        private static byte[] Play(List<Frame> frames, IShotDetector detector)
        {
            var found = new List<byte>();
            var detections = new Detections();
            foreach (Frame frame in frames)
            {
                detector.Process(frame, detections);
                Add(found, detections);
            }

            return found.ToArray();
        }

        private static List<Frame> Draw(PixelFormat format)
        {
            var frames = new List<Frame>();
            var builder = new FrameBuilder(321, 243);
            for (int i = 0; i < 30; i++)
            {
                var frame = new Frame();
                builder.Wall(60, 70, 65).Box(5 * i, 40, 50, 60, 120, 90, 140);
                if (i % 10 > 7)
                    builder.GreenDot(250, 190 - 2 * i);
                builder.Write(frame, i, 33_333 * i, format);
                frames.Add(frame);
            }

            return frames;
        }

        private static List<Frame> Record(SimulationScenario scenario) => Record(new SimulatedRange(scenario, SimulationScenes.Empty()).CreateColorSource());

        private static List<Frame> Record(IFrameSource source)
        {
            var frames = new List<Frame>();
            for (var frame = new Frame(); source.TryRead(frame); frame = new Frame())
                frames.Add(frame);
            source.Dispose();
            return frames;
        }

        private static byte[] PlayKnown(SimulatedRange range, List<Frame> frames, List<Frame> pictures, KernelRunner kernels)
        {
            var history = new RenderedFrameHistory();
            var detector = new ShotDetector(null, new ExpectedView(history, range.Calibration, null, kernels), kernels);
            var found = new List<byte>();
            var detections = new Detections();
            bool wasTrusted = false;
            int next = 0;
            foreach (Frame frame in frames)
            {
                for (; next < pictures.Count && pictures[next].TimeUs <= frame.TimeUs; next++)
                    history.Add(pictures[next].Color, pictures[next].TimeUs);
                detector.Process(frame, detections);
                Add(found, detections);
                wasTrusted |= detections.Prediction == PredictionState.Trusted;
            }

            Assert.That(wasTrusted, Is.True, "the rendered pictures were relied on");
            return found.ToArray();
        }

        private static byte[] PlayHands(SimulatedRange range, List<Frame> frames, KernelRunner kernels)
        {
            var tracker = new DepthHandTracker(range.Calibration.HandCamera!, null, kernels);
            var found = new List<byte>();
            var observations = new HandObservations();
            foreach (Frame frame in frames)
            {
                tracker.Process(frame, observations);
                FieldBytes.AddAll(found, observations.Hands);
                FieldBytes.AddAll(found, observations.People);
            }

            return found.ToArray();
        }

        private static void Add(List<byte> found, Detections detections)
        {
            FieldBytes.AddAll(found, detections.Dots);
            FieldBytes.AddAll(found, detections.Rejected);
        }

        private static byte[] Look(byte[] file, Image picture, KernelRunner kernels)
        {
            using HandLandmarkNetwork network = HandLandmarkNetwork.Read(file, "test", kernels);
            var landmarks = new HandLandmarks();
            network.Run(picture, new HandRegion(picture.Width * 0.5, picture.Height * 0.4, picture.Height * 0.9, 0.3), landmarks);
            var answer = new List<byte>();
            FieldBytes.AddAll(answer, landmarks.PicturePx);
            return answer.ToArray();
        }

        /// <summary>With the inputs and outputs of the hand model, and all its operators.</summary>
        private static byte[] Network()
        {
            var random = new Random(9);
            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 224, 224, 3), small = builder.Tensor(1, 56, 56, 16), deep = builder.Tensor(1, 28, 28, 16), sum = builder.Tensor(1, 28, 28, 16);
            int pooled = builder.Tensor(1, 14, 14, 16), mean = builder.Tensor(1, 16);
            builder.Operator(3, small, new[] { from, Weights(builder, random, 16, 3, 3, 3), Weights(builder, random, 16) }, (byte)0, 4, 4, (byte)3);
            builder.Operator(4, deep, new[] { small, Weights(builder, random, 1, 5, 5, 16), Weights(builder, random, 16) }, (byte)0, 2, 2, 1, (byte)3);
            builder.Operator(0, sum, new[] { deep, deep }, (byte)0);
            builder.Operator(17, pooled, new[] { sum }, (byte)0, 2, 2, 2, 2, (byte)0);
            builder.Operator(40, mean, new[] { pooled, builder.Integers(new[] { 1, 2 }, 2) }, (byte)0);
            int landmarks = Linear(builder, random, mean, 63), there = builder.Tensor(1, 1), right = builder.Tensor(1, 1);
            builder.Operator(14, there, new[] { Linear(builder, random, mean, 1) });
            builder.Operator(14, right, new[] { Linear(builder, random, mean, 1) });
            return builder.Build(new[] { from }, landmarks, there, right, Linear(builder, random, mean, 63));
        }

        private static int Linear(TfLiteBuilder builder, Random random, int input, int outputs)
        {
            int to = builder.Tensor(1, outputs);
            builder.Operator(9, to, new[] { input, Weights(builder, random, outputs, 16), Weights(builder, random, outputs) }, (byte)0);
            return to;
        }

        private static int Weights(TfLiteBuilder builder, Random random, params int[] shape) =>
            builder.Constant(Enumerable.Range(0, shape.Aggregate((a, b) => a * b)).Select(_ => random.NextSingle() - 0.4f).ToArray(), shape);
    }
}
