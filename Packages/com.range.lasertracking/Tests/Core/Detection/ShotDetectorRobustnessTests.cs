using System;
using System.Text;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class ShotDetectorRobustnessTests
    {
        [TestCase(1, 1, PixelFormat.Bgra32)]
        [TestCase(3, 2, PixelFormat.Bgra32)]
        [TestCase(17, 33, PixelFormat.Gray8)]
        [TestCase(1301, 35, PixelFormat.Bgra32)]
        [TestCase(1302, 34, PixelFormat.Nv12)]
        [TestCase(1302, 35, PixelFormat.Yuy2)]
        [TestCase(1303, 31, PixelFormat.Gray8)]
        public void Process_OddSizes_RunThrough(int width, int height, PixelFormat format)
        {
            var run = new DetectionRun(null, width, height) { Format = format };
            run.Play(0, 6, (b, i) => b.Wall(i % 2 == 0 ? 0 : 255, 255 - 40 * i, 90));
            Assert.That(run.Detections.FrameIndex, Is.EqualTo(5));
        }

        [Test]
        public void Process_SizeAndFormatChangeInMidStream_StartAfresh()
        {
            var detector = new ShotDetector();
            var small = new DetectionRun(detector, 64, 48);
            var large = new DetectionRun(detector, 320, 240);
            small.Play(0, 5, (b, i) => b.Wall(90, 100, 110));
            large.Play(5, 5, (b, i) => b.Wall(90, 100, 110));
            large.Format = PixelFormat.Nv12;
            large.Play(10, 8, (b, i) => b.Wall(90, 100, 110));
            large.Play(18, 1, (b, i) => b.Wall(90, 100, 110).GreenDot(100, 100));
            Assert.That(small.Shots, Is.Empty);
            Assert.That(large.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_FrameWithoutPicture_LeavesTheStateAlone()
        {
            var run = new DetectionRun();
            run.Play(0, 8, (b, i) => b.Wall(90, 100, 110));
            run.Frame.Begin(8, 8 * run.IntervalUs);
            run.Detector.Process(run.Frame, run.Detections);
            run.Tracker.Process(run.Detections);
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(0));
            run.Play(9, 1, (b, i) => b.Wall(90, 100, 110).GreenDot(100, 100));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [TestCase(0)]
        [TestCase(-1000)]
        public void Process_TimeThatStandsStillOrRunsBack_IsSurvived(int step)
        {
            var run = new DetectionRun();
            for (int i = 0; i < 120; i++)
            {
                run.Builder.Wall(90, 100, 110);
                if (i % 20 == 10)
                    run.Builder.GreenDot(50 + i, 100);
                run.Builder.Write(run.Frame, i, (long)i * step);
                run.Detector.Process(run.Frame, run.Detections);
                run.Tracker.Process(run.Detections);
                foreach (Shot shot in run.Tracker.Shots)
                    run.Shots.Add(shot);
            }

            Assert.That(run.Shots.Count, Is.GreaterThanOrEqualTo(3));
        }

        [Test]
        public void Process_TenThousandSparks_IsBoundedAndSaysSo()
        {
            var run = new DetectionRun(null, 1000, 1000);
            run.Builder.NoiseSigma = 0;
            run.Play(0, 4, (b, i) => b.Wall(40, 40, 40));
            run.Builder.Wall(40, 40, 40);
            for (int i = 0; i < 10000; i++)
                run.Builder.Box(i % 100 * 10, i / 100 * 10, 3, 3, 255, 255, 255);
            run.Builder.Write(run.Frame, 4, 4 * run.IntervalUs);
            var trace = new DetectionTrace(4096);
            ((ShotDetector)run.Detector).Trace = trace;
            run.Detector.Process(run.Frame, run.Detections);
            Assert.That(trace.Candidates.Length, Is.InRange(64, 4 * new ShotDetectorSettings().MaxCandidates), "the number examined bounds the time");
            Assert.That(run.Detections.OverflowCount, Is.GreaterThan(1000));
        }

        [Test]
        public void Process_SameInputTwice_GivesTheSameBits() => Assert.That(Transcript(true), Is.EqualTo(Transcript(true)));

        [Test]
        public void Process_WithAndWithoutVectors_GivesTheSameBits()
        {
            string transcript = Transcript(true);
            Assert.That(transcript, Is.EqualTo(Transcript(false)));
            Assert.That(transcript.Length, Is.GreaterThan(200));
        }

        [Test]
        public void Process_OnceWarm_AllocatesNothing()
        {
            var run = new DetectionRun();
            var frames = new Frame[8];
            for (int i = 0; i < frames.Length; i++)
            {
                run.Builder.Wall(90, 100, 110).Box(10 + 9 * i, 30, 30, 30, 240, 240, 240);
                if (i >= 5)
                    run.Builder.GreenDot(200 + i, 150);
                frames[i] = new Frame();
                run.Builder.Write(frames[i], i, i * run.IntervalUs);
            }

            for (int round = 0; round < 5; round++)
                Play(run, frames);
            Assert.That(Allocation.Of(() => Play(run, frames)), Is.EqualTo(0));
        }

        [TestCase(double.NaN)]
        [TestCase(-0.1)]
        public void Constructor_BadSetting_NamesIt(double value)
        {
            ArgumentException? error = Assert.Throws<ArgumentException>(() => new ShotDetector(new ShotDetectorSettings { MinRise = value }));
            Assert.That(error!.Message, Does.Contain("MinRise"));
        }

        [Test]
        public void SetScreenPolygon_WithoutAreaOrNotFinite_IsRefused()
        {
            var detector = new ShotDetector();
            Assert.Throws<ArgumentException>(() => detector.SetScreenPolygon(new[] { new Vector2D(0, 0), new Vector2D(5, 5), new Vector2D(9, 9) }));
            Assert.Throws<ArgumentException>(() => detector.SetScreenPolygon(new[] { new Vector2D(0, 0), new Vector2D(5, double.NaN), new Vector2D(9, 0) }));
        }

        private static void Play(DetectionRun run, Frame[] frames)
        {
            foreach (Frame frame in frames)
            {
                run.Detector.Process(frame, run.Detections);
                run.Tracker.Process(run.Detections);
            }
        }

        private static string Transcript(bool useVectors)
        {
            var run = new DetectionRun(new ShotDetector(new ShotDetectorSettings { UseVectors = useVectors, FullSizeMaxWidthPx = 400 }), 517, 203);
            run.Builder.NoiseSigma = 3;
            var text = new StringBuilder();
            for (int i = 0; i < 24; i++)
            {
                run.Play(i, 1, (b, n) =>
                {
                    b.Wall(90, 100, 110).Box(10 + 9 * n, 30, 30, 30, 240, 240, 240);
                    if (n % 8 >= 6)
                        b.GreenDot(300 + n, 150);
                });
                foreach (Dot dot in run.Detections.Dots)
                    text.Append(BitConverter.DoubleToInt64Bits(dot.PositionPx.X)).Append(' ').Append(BitConverter.DoubleToInt64Bits(dot.Confidence)).Append('\n');
                foreach (RejectedCandidate c in run.Detections.Rejected)
                    text.Append(c.Reason).Append(' ').Append(BitConverter.DoubleToInt64Bits(c.Value)).Append('\n');
            }

            return text.ToString();
        }
    }
}
