using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Health;
using LaserTracking.Imaging;
using LaserTracking.Pipeline;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>All benchmarks by the names that others rely on.</summary>
    internal static class BenchmarkList
    {
        private const int LoopFrames = 24;

        public static IReadOnlyList<Benchmark> All { get; } = new[]
        {
            new Benchmark("detect-1080p", "1920×1080 BGRA frame in, shots out; moving scene, 2 dots", () => Detect("shots", 1920, 1080, PixelFormat.Bgra32)),
            new Benchmark("detect-720p-nv12", "1280×720 NV12 frame in, shots out; moving scene, 2 dots", () => Detect("shots", 1280, 720, PixelFormat.Nv12)),
            new Benchmark("paper-1080p", "the published algorithm at 960 px width on 1920×1080 BGRA; moving scene, 2 dots", () => Detect("paper", 1920, 1080, PixelFormat.Bgra32)),
            new Benchmark("dual-1080p", "1024×1024 16-bit infrared and 1920×1080 BGRA in, shots out; moving scene, 3 dots at 850 nm", () => Dual(true)),
            new Benchmark("dual-infrared-1080p", "the same without a search of colour: colour is read around infrared spots only, as in the published module", () => Dual(false)),
            new Benchmark("health-1080p", "1920×1080 BGRA frame in, checks of the picture itself; moving scene, 2 dots", Health),
            new Benchmark("predict-1080p", "rendered frames known: what they cost on top of the search at 1920×1080; 640×360 pictures at 60 a second, everything moves", PredictionBenchmark.Prepare),
            new Benchmark("hands-640x576", "depth frame in, hands out; 2 people", Hands),
            HandModelBenchmark.Create("hand-landmarks-lite", HandModelFile.Lite),
            HandModelBenchmark.Create("hand-landmarks-full", HandModelFile.Full),
            new Benchmark("sort-6", "6 boxes in, tracks out; SORT", () => TrackingBenchmarks.Sort(6)),
            new Benchmark("sort-10", "10 boxes in, tracks out; SORT", () => TrackingBenchmarks.Sort(10)),
            new Benchmark("dots-8", "8 dots in, their numbers out; dot tracker", () => TrackingBenchmarks.Dots(8)),
            new Benchmark("dots-50", "50 dots in, their numbers out; dot tracker", () => TrackingBenchmarks.Dots(50)),
            new Benchmark("pair-multiuser", "4 shots of one frame to 4 hands", PairBenchmark.Prepare),
            new Benchmark("pair-picture", "4 shots of one frame to the hands of 4 simulated people, with camera 1's picture", PairBenchmark.PrepareWithPicture),
            new Benchmark("lens-table", "a table of rays for a depth camera's 1920×1080 colour lens, error at most 0.01 px", LensBenchmark.BuildTable),
            new Benchmark("lens-lookup", "1,000,000 pixels at random places to rays by that table", LensBenchmark.LookUp),
            new Benchmark("lens-exact", "the same 1,000,000 pixels to exact rays by Newton's method", LensBenchmark.Exact),
            new Benchmark("calibrate-stereo", "13 pairs of 48 corners: both cameras and how they stand to each other", StereoBenchmark.Prepare),
            new Benchmark("decode-720p-mjpg", "one 1280×720 4:2:2 JPEG to YUY2", Decode),
            new Benchmark("record-720p-nv12", "one 1280×720 NV12 frame laid out and summed for a recording, every bit of it; without the disk", RecordingBenchmarks.Whole),
            new Benchmark("record-jpeg-720p", "the same as a JPEG of quality 90", RecordingBenchmarks.Jpeg),
            new Benchmark("crop-screen-1080p", "the screen's part cut out of a 1920×1080 BGRA frame: what recording costs the capture thread", () => RecordingBenchmarks.Screen(false)),
            new Benchmark("record-screen-1080p", "the same and laid out and summed", () => RecordingBenchmarks.Screen(true)),
            new Benchmark("board-1080p", "1920×1080 grey picture in, 9×6 corners of a board out; clutter, tilt, lens, blur, noise", BoardBenchmark.Prepare),
            new Benchmark("screen-1080p", "8 frames of 1920×1080 of the screen's pattern in, its calibration with lens and proof out", ScreenPatternBenchmark.Prepare),
            new Benchmark("end-to-end-720p", "1280×720 NV12 frame in, scored hit and event line out; 2 shooters, shots all the time", EndToEnd),
        };

        private static Action<int> Detect(string detectorName, int width, int height, PixelFormat format) =>
            Detect(DetectFrames(width, height, format, LoopFrames), Sessions.RangeSession.CreateDetector(detectorName));

        private static Action<int> Detect(FrameLoop frames, IShotDetector detector)
        {
            var tracker = new ShotTracker();
            var detections = new Detections();
            return number =>
            {
                Capture.Frame frame = frames[number];
                detections.Begin(frame.Index, frame.TimeUs);
                detector.Process(frame, detections);
                tracker.Process(detections);
            };
        }

        private static Action<int> Dual(bool searchesColor)
        {
            FrameLoop frames = DualFrames(LoopFrames, out SimulatedRange range);
            return Detect(frames, new DualShotDetector(new DualDetectorSettings { SearchesColor = searchesColor }, range.InfraredMapping));
        }

        /// <summary>The moving scene with two lasers held on, as the detectors' benchmarks see it.</summary>
        internal static FrameLoop DetectFrames(int width, int height, PixelFormat format, int count) =>
            new(FrameLoop.Range(width, height, format, 2, 2000, 90).CreateColorSource(), count);

        /// <summary>The same with three 850 nm emitters, in colour and in infrared.</summary>
        internal static FrameLoop DualFrames(int count, out SimulatedRange range)
        {
            SimulationScenario scenario = FrameLoop.Scenario(1920, 1080, PixelFormat.Bgra32, 3, 2000, 90);
            scenario.InfraredCamera.Enabled = true;
            foreach (ShooterSettings shooter in scenario.Shooters)
                shooter.Laser.Color = LaserColor.Infrared;
            range = new SimulatedRange(scenario, SimulationScenes.Default());
            return new FrameLoop(range.CreateColorSource(), count);
        }

        private static Action<int> Health()
        {
            var frames = new FrameLoop(FrameLoop.Range(1920, 1080, PixelFormat.Bgra32, 2, 2000, 90).CreateColorSource(), LoopFrames);
            var monitor = new PictureMonitor(new SessionRecorder());
            return number => monitor.Process(frames[number]);
        }

        private static Action<int> Hands()
        {
            SimulatedRange range = FrameLoop.Range(320, 180, PixelFormat.Nv12, 2, 40, 10);
            var frames = new FrameLoop(range.CreateDepthSource(), LoopFrames);
            var tracker = new DepthHandTracker(range.Calibration.HandCamera!);
            var hands = new HandObservations();
            return number => tracker.Process(frames[number], hands);
        }

        private static Action<int> Decode()
        {
            var frames = new FrameLoop(FrameLoop.Range(1280, 720, PixelFormat.Yuy2, 2, 2000, 90).CreateColorSource(), 4);
            byte[] jpeg = new JpegEncoder(90).Encode(frames[0].Color).ToArray();
            var decoder = new JpegDecoder();
            var target = new Image();
            return _ => decoder.TryDecode(jpeg, target, 0, out string _);
        }

        private static Action<int> EndToEnd()
        {
            SimulatedRange range = FrameLoop.Range(1280, 720, PixelFormat.Nv12, 2, 20, 4);
            var screenFrames = new FrameLoop(range.CreateColorSource(), LoopFrames);
            var handFrames = new FrameLoop(range.CreateDepthSource(), LoopFrames);
            var pipeline = RangePipeline.CreateDefault(new ShotDetector(), range.Calibration, true, new ShotScorer(range.Scene), new JsonLinesSink(Stream.Null));
            pipeline.Begin(new SessionHeader("bench", Array.Empty<SessionInput>(), null, "shots", null));
            return number =>
            {
                pipeline.ProcessHands(handFrames[number]);
                pipeline.Process(screenFrames[number]);
            };
        }
    }
}
