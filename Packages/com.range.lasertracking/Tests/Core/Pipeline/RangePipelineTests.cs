using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Imaging;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Pipeline
{
    public sealed class RangePipelineTests
    {
        [Test]
        public void RangePipeline_SimulatedShots_AreReportedOnceWithPlaceAndHit()
        {
            SimulatedRange range = SmallRange();
            var recorder = new SessionRecorder();
            Run(range, recorder);

            ShotEvent[] shots = recorder.ShotsByTime();
            Assert.That(shots.Length, Is.EqualTo(range.Truth.Shots.Count));
            for (int i = 0; i < shots.Length; i++)
            {
                TrueShot truth = range.Truth.Shots[i];
                Assert.That(shots[i].HasScreenPosition, Is.True);
                Assert.That((shots[i].ScreenM - truth.ScreenM).Length, Is.LessThan(0.01));
                Assert.That(shots[i].Shot.FirstFrameIndex, Is.EqualTo(truth.FirstFrame));
                Assert.That(shots[i].HasHit ? shots[i].Hit.Target : string.Empty, Is.EqualTo(truth.Target));
            }
        }

        [Test]
        [Category("Long")]
        public void RangePipeline_SameInputTwice_WritesTheSameBytes()
        {
            Assert.That(Events(SmallRange(), false), Is.EqualTo(Events(SmallRange(), false)));
        }

        [Test]
        [Category("Long")]
        public void RangePipeline_SourcesReadAheadOnOtherThreads_WritesTheSameBytes()
        {
            Assert.That(Events(SmallRange(), true), Is.EqualTo(Events(SmallRange(), false)));
        }

        [Test]
        [Category("Long")]
        public void RangePipeline_EventsFile_IsInOrderOfTime()
        {
            long last = long.MinValue;
            foreach (string line in Events(SmallRange(), false).Split('\n').Where(l => l.Contains("\"time_us\":")))
            {
                int at = line.IndexOf("\"time_us\":", StringComparison.Ordinal) + 10;
                long time = long.Parse(line.Substring(at, line.IndexOf(',', at) - at));
                Assert.That(time, Is.GreaterThanOrEqualTo(last), line);
                last = time;
            }
        }

        [Test]
        public void RangePipeline_WarmFrameLoop_AllocatesNothing()
        {
            SimulatedRange range = SmallRange();
            List<Frame> frames = AllFrames(range.CreateColorSource()), hands = AllFrames(range.CreateDepthSource());
            RangePipeline pipeline = Create(range, new JsonLinesSink(Stream.Null));
            pipeline.Begin(Header());
            long lengthUs = frames[frames.Count - 1].TimeUs + 33_333;
            int round = 0;
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < frames.Count; i++)
                {
                    if (i < hands.Count)
                        pipeline.ProcessHands(Shifted(hands[i], round, lengthUs));
                    pipeline.Process(Shifted(frames[i], round, lengthUs));
                }

                round++;
            });
            Assert.That(allocated, Is.EqualTo(0));
        }

        [Test]
        [Category("Long")]
        public void RangePipeline_FramesWithoutAPicture_AreCountedAndSaid()
        {
            SimulatedRange range = SmallRange();
            var recorder = new SessionRecorder();
            RangePipeline pipeline = Create(range, recorder);
            pipeline.Begin(Header());
            List<Frame> frames = AllFrames(range.CreateColorSource());
            frames[3].Color.Clear();
            frames[4].Color.Clear();
            foreach (Frame frame in frames)
                pipeline.Process(frame);
            pipeline.End(0);
            Assert.That(recorder.Summary.Dropped, Is.EqualTo(2));
            Assert.That(recorder.Health.Count(h => h.Kind == HealthKind.FrameGap), Is.EqualTo(1));
        }

        [Test]
        [Category("Long")]
        public void RangePipeline_TimeRunsBack_IsSaidAndDoesNotStop()
        {
            SimulatedRange range = SmallRange();
            var recorder = new SessionRecorder();
            RangePipeline pipeline = Create(range, recorder);
            pipeline.Begin(Header());
            List<Frame> frames = AllFrames(range.CreateColorSource());
            frames[5].TimeUs = frames[5].Color.TimeUs = frames[2].TimeUs;
            foreach (Frame frame in frames)
                pipeline.Process(frame);
            pipeline.End(0);
            Assert.That(recorder.Health.Count(h => h.Kind == HealthKind.FrameGap), Is.GreaterThanOrEqualTo(1));
        }

        [Test]
        public void RangePipeline_CameraOneFallsSilent_IsSaidOnceAndWhenItIsBack()
        {
            SimulatedRange range = SmallRange();
            var recorder = new SessionRecorder();
            RangePipeline pipeline = Create(range, recorder);
            pipeline.Begin(Header());
            using var frame = new Frame();
            using var hands = new Frame();
            for (int i = 0; i < 120; i++)
            {
                // The times alone count here; while it is away a live camera gives frames without a picture.
                frame.Begin(i, i * 33_333L);
                hands.Begin(i, frame.TimeUs);
                if (i < 20 || i > 60)
                {
                    hands.Depth.Reset(PixelFormat.Depth16, 4, 4, frame.TimeUs);
                    hands.Depth.Bytes.Clear();
                }

                pipeline.ProcessHands(hands);
                pipeline.Process(frame);
            }

            HealthEvent[] said = recorder.Health.Where(h => h.Kind == HealthKind.HandCamera).ToArray();
            Assert.That(said.Length, Is.EqualTo(2));
            Assert.That(said[0].Value, Is.EqualTo(0.53).Within(0.04), "seconds of silence");
            Assert.That(said[1].FrameIndex, Is.InRange(61, 80));
        }

        [Test]
        [Category("Long")]
        public void RangePipeline_CameraOneNeverComes_ShotsGoOnWithoutAShooter()
        {
            SimulatedRange range = SmallRange();
            var recorder = new SessionRecorder();
            RangePipeline pipeline = Create(range, recorder);
            pipeline.Begin(Header());
            foreach (Frame frame in AllFrames(range.CreateColorSource()))
                pipeline.Process(frame);
            pipeline.End(0);
            Assert.That(recorder.Shots.Count, Is.EqualTo(2));
            Assert.That(recorder.Shots.All(s => s.Shooter == 0 && !s.HasMuzzle && s.HasHit), Is.True);
            Assert.That(recorder.CountOf(HealthKind.HandCamera), Is.EqualTo(1));
        }

        [TestCase(-0.1, 2.5)]
        [TestCase(double.NaN, 2.5)]
        [TestCase(0.5, 1.0)]
        [TestCase(0.5, double.NaN)]
        public void PipelineSettings_OutsideTheirRange_AreRefused(double blind, double gap)
        {
            var settings = new PipelineSettings { BlindShareLimit = blind, FrameGapFactor = gap };
            Assert.That(() => settings.Validate(), Throws.InstanceOf<ArgumentException>());
        }

        private static Frame Shifted(Frame frame, int round, long lengthUs)
        {
            if (round > 0)
            {
                frame.TimeUs += lengthUs;
                frame.Color.TimeUs += lengthUs;
                frame.Depth.TimeUs += lengthUs;
            }

            return frame;
        }

        private static SimulatedRange SmallRange()
        {
            var scenario = new SimulationScenario { Seed = 3, DurationS = 1.2 };
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.ColorCamera.Format = PixelFormat.Nv12;
            scenario.DepthCamera.Binned = true;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shots.Add(new ShotSettings { TimeS = 0.4, PulseMs = 40, Target = "Paper 1" });
            scenario.Shots.Add(new ShotSettings { TimeS = 0.8, PulseMs = 40, Target = "Silhouette 1" });
            return new SimulatedRange(scenario, SimulationScenes.Default());
        }

        private static RangePipeline Create(SimulatedRange range, IEventSink sink)
        {
            return RangePipeline.CreateDefault(new ShotDetector(), range.Calibration, true, new ShotScorer(range.Scene), sink,
                new PipelineSettings { SceneTimeZeroUs = range.Truth.ColorClockUs(0) });
        }

        private static SessionHeader Header() => new SessionHeader("test", Array.Empty<SessionInput>(), null, "shots", 3);

        private static void Run(SimulatedRange range, IEventSink sink, bool readAhead = false)
        {
            RangePipeline pipeline = Create(range, sink);
            pipeline.Begin(Header());
            IFrameSource color = range.CreateColorSource(), depth = range.CreateDepthSource();
            if (readAhead)
            {
                color = new PrefetchingFrameSource(color);
                depth = new PrefetchingFrameSource(depth);
            }

            using (color)
            using (depth)
                Assert.That(new SessionRunner(pipeline, color, depth, range.Truth.ColorClockUs(0) - range.Truth.DepthClockUs(0)).Run(CancellationToken.None), Is.True);
            pipeline.End(0);
        }

        private static string Events(SimulatedRange range, bool readAhead)
        {
            using (var stream = new MemoryStream())
            {
                Run(range, new JsonLinesSink(stream), readAhead);
                return Encoding.UTF8.GetString(stream.ToArray());
            }
        }

        private static List<Frame> AllFrames(IFrameSource source)
        {
            var frames = new List<Frame>();
            using (source)
            {
                while (true)
                {
                    var frame = new Frame();
                    if (!source.TryRead(frame))
                        return frames;
                    frames.Add(frame);
                }
            }
        }
    }
}
