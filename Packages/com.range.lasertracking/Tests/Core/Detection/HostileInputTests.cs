using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using LaserTracking.Pipeline;
using LaserTracking.Session;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>What must hold whatever comes in: for every detector, through the tracker and the pipeline.</summary>
    public sealed class HostileInputTests
    {
        private const int Frames = 300;

        [Test]
        public void Detector_HostileFrames_KeepsItsPromises([Values("shots", "paper")] string name, [Range(1, 8)] int seed)
        {
            IShotDetector detector = Create(name, true);
            var frames = new HostileFrames(seed);
            var tracker = new ShotTracker();
            var detections = new Detections();
            int lastShot = 0;
            using (var frame = new Frame())
            {
                for (int i = 0; i < Frames; i++)
                {
                    frames.Next(frame);
                    detector.Process(frame, detections);
                    CheckDetections(detections, frame);
                    tracker.Process(detections);
                    foreach (Shot shot in tracker.Shots)
                    {
                        Assert.That(shot.Id, Is.EqualTo(++lastShot));
                        Assert.That(shot.FirstFrameIndex, Is.LessThanOrEqualTo(shot.FrameIndex));
                        Assert.That(shot.LastFrameIndex, Is.InRange(shot.FirstFrameIndex, shot.FrameIndex));
                        Assert.That(shot.TimeSigmaUs, Is.GreaterThanOrEqualTo(0));
                    }

                    CheckRejected(tracker.Rejected);
                }
            }
        }

        [Test]
        public void Detector_WithAndWithoutVectors_GivesTheSameBits([Range(11, 18)] int seed)
        {
            Assert.That(Transcript(Create("shots", false), seed, 0, false), Is.EqualTo(Transcript(Create("shots", true), seed, 0, false)));
        }

        [Test]
        public void Detector_PaddedRows_GivesTheSameBits([Values("shots", "paper")] string name, [Range(21, 24)] int seed)
        {
            string padded = Transcript(Create(name, true), seed, 0xFF, false);
            Assert.That(Transcript(Create(name, true), seed, 0, false), Is.EqualTo(padded));
            Assert.That(Transcript(Create(name, true), seed, 0, true), Is.EqualTo(padded));
        }

        [Test]
        public void Pipeline_HostileFrames_WritesEveryLineInOrder([Values("shots", "paper")] string name, [Values(31, 32, 33)] int seed)
        {
            using (var stream = new MemoryStream())
            using (var frame = new Frame())
            {
                RangePipeline pipeline = RangePipeline.CreateDefault(Create(name, true), null, false, null, new JsonLinesSink(stream));
                pipeline.Begin(new SessionHeader("1.0.0", new SessionInput[0], null, name, null));
                var frames = new HostileFrames(seed);
                for (int i = 0; i < Frames; i++)
                {
                    frames.Next(frame);
                    pipeline.Process(frame);
                }

                pipeline.End(1);
                string[] lines = Encoding.UTF8.GetString(stream.ToArray()).TrimEnd('\n').Split('\n');
                Assert.That(lines[0], Does.StartWith("{\"type\":\"header\""));
                Assert.That(lines[lines.Length - 1], Does.StartWith("{\"type\":\"end\",\"frames\":" + Frames));
                foreach (string line in lines)
                    Assert.That(line, Does.StartWith("{").And.EndWith("}").And.Not.Contain("NaN").And.Not.Contain("Infinity"));
            }
        }

        [Test]
        public void Pipeline_TenThousandSparks_SaysSoOnce()
        {
            var recorder = new SessionRecorder();
            RangePipeline pipeline = RangePipeline.CreateDefault(new ShotDetector(), null, false, null, recorder);
            pipeline.Begin(new SessionHeader("1.0.0", new SessionInput[0], null, "shots", null));
            var builder = new FrameBuilder(1000, 1000) { NoiseSigma = 0 };
            using (var frame = new Frame())
            {
                for (int i = 0; i < 15; i++)
                {
                    builder.Wall(40, 40, 40);
                    for (int n = 0; n < (i >= 5 ? 10000 : 0); n++)
                        builder.Box(n % 100 * 10 + i - 5, n / 100 * 10, 3, 3, 255, 255, 255);
                    builder.Write(frame, i, i * 33333);
                    pipeline.Process(frame);
                }
            }

            pipeline.End(1);
            int overflows = 0;
            foreach (HealthEvent health in recorder.Health)
                overflows += health.Kind == HealthKind.Overflow ? 1 : 0;
            Assert.That(overflows, Is.EqualTo(1));
            Assert.That(recorder.ShotsByTime().Length, Is.LessThanOrEqualTo(10 * ShotTracker.MaxShotsPerFrame));
        }

        [TestCase(0)]
        [TestCase(255)]
        public void Detector_FramesOfOneValue_FindNothing(int value)
        {
            foreach (string name in new[] { "shots", "paper" })
            {
                IShotDetector detector = Create(name, true);
                var detections = new Detections();
                using (var frame = new Frame())
                {
                    for (int i = 0; i < 20; i++)
                    {
                        frame.Begin(i, i * 33333);
                        frame.Color.Reset(PixelFormat.Bgra32, 320, 240, frame.TimeUs);
                        frame.Color.Bytes.Fill((byte)value);
                        detector.Process(frame, detections);
                        Assert.That(detections.Dots.Length, Is.EqualTo(0), name);
                    }
                }
            }
        }

        [TestCaseSource(nameof(NumericSettings))]
        public void Settings_NotANumberOrFarOutside_AreRefused(Type settings, string property)
        {
            foreach (double bad in new[] { double.NaN, double.PositiveInfinity, -1e9, 1e9 })
            {
                object instance = Activator.CreateInstance(settings)!;
                System.Reflection.PropertyInfo of = settings.GetProperty(property)!;
                if (of.PropertyType == typeof(double))
                    of.SetValue(instance, bad);
                else if (double.IsNaN(bad) || double.IsInfinity(bad))
                    continue;
                else
                    of.SetValue(instance, Convert.ChangeType(bad, of.PropertyType));
                Exception? refused = Assert.Catch(() => settings.GetMethod("Validate")!.Invoke(instance, null));
                Assert.That(refused!.InnerException, Is.TypeOf<ArgumentException>());
                Assert.That(refused.InnerException!.Message, Does.Contain(property));
            }
        }

        private static IEnumerable<TestCaseData> NumericSettings()
        {
            foreach (Type type in new[] { typeof(ShotDetectorSettings), typeof(PaperDetectorSettings), typeof(ShotTrackerSettings) })
            {
                foreach (System.Reflection.PropertyInfo property in type.GetProperties())
                {
                    if (property.PropertyType == typeof(double) || property.PropertyType == typeof(int) || property.PropertyType == typeof(long))
                        yield return new TestCaseData(type, property.Name);
                }
            }
        }

        private static IShotDetector Create(string name, bool useVectors) =>
            name == "paper" ? (IShotDetector)new PaperShotDetector() : new ShotDetector(new ShotDetectorSettings { UseVectors = useVectors });

        private static void CheckDetections(Detections detections, Frame frame)
        {
            Assert.That(detections.FrameIndex, Is.EqualTo(frame.Index));
            Assert.That(detections.BlindShare, Is.InRange(0.0, 1.0));
            Assert.That(detections.OverflowCount, Is.GreaterThanOrEqualTo(0));
            foreach (Dot dot in detections.Dots)
            {
                Assert.That(dot.PositionPx.X, Is.InRange(-1.0, frame.Color.Width));
                Assert.That(dot.PositionPx.Y, Is.InRange(-1.0, frame.Color.Height));
                Assert.That(dot.Confidence, Is.InRange(0.0, 1.0));
                Assert.That(dot.Peak, Is.InRange(0, 255));
                Assert.That(dot.AreaPx, Is.GreaterThanOrEqualTo(0));
                Assert.That(dot.StreakPx.IsFinite, Is.True);
                Assert.That(dot.CovariancePx.XX, Is.GreaterThan(0).And.LessThan(1e9));
                Assert.That(dot.CovariancePx.YY, Is.GreaterThan(0).And.LessThan(1e9));
                Assert.That(dot.CovariancePx.XX * dot.CovariancePx.YY - dot.CovariancePx.XY * dot.CovariancePx.XY, Is.GreaterThan(0));
            }

            CheckRejected(detections.Rejected);
        }

        private static void CheckRejected(ReadOnlySpan<RejectedCandidate> candidates)
        {
            foreach (RejectedCandidate rejected in candidates)
            {
                Assert.That(rejected.Reason, Is.Not.EqualTo(RejectionReason.None));
                Assert.That(rejected.PositionPx.IsFinite, Is.True);
                Assert.That(double.IsNaN(rejected.Value) || double.IsInfinity(rejected.Value), Is.False, rejected.Reason.ToString());
                Assert.That(double.IsNaN(rejected.Limit) || double.IsInfinity(rejected.Limit), Is.False, rejected.Reason.ToString());
            }
        }

        private static string Transcript(IShotDetector detector, int seed, byte padding, bool isTight)
        {
            var frames = new HostileFrames(seed) { PaddingFill = padding };
            var detections = new Detections();
            var text = new StringBuilder();
            using (var frame = new Frame())
            using (var tight = new Frame())
            {
                for (int i = 0; i < Frames; i++)
                {
                    frames.Next(frame);
                    tight.Begin(frame.Index, frame.TimeUs);
                    if (isTight && frame.Color.IsPresent)
                        HostileFrames.CopyTight(frame.Color, tight.Color);
                    detector.Process(isTight ? tight : frame, detections);
                    foreach (Dot dot in detections.Dots)
                        text.Append(BitConverter.DoubleToInt64Bits(dot.PositionPx.X)).Append(' ').Append(BitConverter.DoubleToInt64Bits(dot.CovariancePx.XX)).Append(dot.Color).Append(dot.IsConclusive).Append('\n');
                    foreach (RejectedCandidate rejected in detections.Rejected)
                        text.Append(BitConverter.DoubleToInt64Bits(rejected.PositionPx.Y)).Append(rejected.Reason).Append(BitConverter.DoubleToInt64Bits(rejected.Value)).Append('\n');
                }
            }

            Assert.That(text.Length, Is.GreaterThan(500));
            return text.ToString();
        }
    }
}
