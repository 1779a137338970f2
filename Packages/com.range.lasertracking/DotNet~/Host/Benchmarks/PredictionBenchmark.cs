using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>
    /// The expected view alone: two rendered pictures into the history, delay, colours, envelope and comparison with the frame. The
    /// search itself is in detect-1080p. Plays one and a half seconds over and over; the jump between costs what any frame does.
    /// </summary>
    internal static class PredictionBenchmark
    {
        private const int Frames = 45;

        public static Action<int> Prepare()
        {
            var scenario = new SimulationScenario { Name = "benchmark", Seed = 11, DurationS = 2 };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Width = 1920;
            scenario.ColorCamera.Height = 1080;
            scenario.Projector.Width = 640;
            scenario.Projector.Height = 360;
            scenario.Projector.Content = ProjectedContent.Shapes;
            var range = new SimulatedRange(scenario, SimulationScenes.Empty());
            var history = new RenderedFrameHistory();
            var probe = new ExpectedViewProbe(new ExpectedView(history, range.Calibration));
            var frames = new Frame[Frames];
            using (IFrameSource camera = range.CreateColorSource())
            {
                for (int i = 0; i < Frames; i++)
                    camera.TryRead(frames[i] = new Frame());
            }

            var pictures = new Frame[2 * Frames];
            using (IFrameSource source = range.CreatePictureSource())
            {
                for (int i = 0; i < pictures.Length; i++)
                    source.TryRead(pictures[i] = new Frame());
            }

            long turnUs = Frames * 33_333L;
            foreach (Frame frame in frames)
                probe.Load(frame);
            return number =>
            {
                int i = number % Frames;
                long startUs = number / Frames * turnUs;
                history.Add(pictures[2 * i].Color, startUs + pictures[2 * i].TimeUs);
                history.Add(pictures[2 * i + 1].Color, startUs + pictures[2 * i + 1].TimeUs);
                probe.Update(i, startUs + frames[i].TimeUs);
            };
        }
    }
}
