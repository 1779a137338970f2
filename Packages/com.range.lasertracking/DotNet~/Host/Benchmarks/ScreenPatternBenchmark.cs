using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using LaserTracking.Patterns;
using LaserTracking.Scoring;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>The four pictures of the screen's calibration as a simulated 1080p camera saw them: found, fitted and proven.</summary>
    internal static class ScreenPatternBenchmark
    {
        private const double HoldMs = 66.7;

        public static Action<int> Prepare()
        {
            var scenario = new SimulationScenario { Name = "pattern", Seed = 5, DurationS = HoldMs * ScreenPattern.Pictures / 1000 };
            (scenario.ColorCamera.Width, scenario.ColorCamera.Height) = (1920, 1080);
            scenario.ColorCamera.LensK1 = -0.1;
            scenario.DepthCamera.Enabled = false;
            (scenario.Projector.Content, scenario.Projector.PatternHoldMs) = (ProjectedContent.Calibration, HoldMs);
            SceneModel scene = SimulationScenes.Empty();
            var frames = new List<Frame>();
            using IFrameSource source = new SimulatedRange(scenario, scene).CreateColorSource();
            for (var frame = new Frame(); source.TryRead(frame); frame = new Frame())
                frames.Add(frame);
            return _ =>
            {
                using var finder = new ScreenPatternFinder();
                foreach (Frame frame in frames)
                    finder.Add(frame.Color);
                ScreenCalibration found = new ScreenCalibrator(scene.ScreenSizeM, 5).Calibrate(finder.Find());
                if (!found.IsAccepted)
                    throw new InvalidOperationException(found.Refusals[0]);
            };
        }
    }
}
