using System;
using System.Collections.Generic;
using LaserTracking.Capture;

namespace LaserTracking.Simulation
{
    /// <summary>What a simulated projector was given, one frame a refresh, with the time of drawing on camera 0's clock.</summary>
    internal sealed class SimulatedPictureSource : IFrameSource
    {
        private readonly SimulationScenario _scenario;
        private readonly SimulationTruth _truth;
        private readonly ProjectorPicture _picture;
        private int _next;

        public SimulatedPictureSource(SimulationScenario scenario, PictureAssets assets, SimulationTruth truth)
        {
            _scenario = scenario;
            _truth = truth;
            _picture = new ProjectorPicture(assets);
            Info = new FrameSourceInfo("pictures of " + scenario.Name, assets.Width, assets.Height, scenario.Projector.RefreshHz, (long)(scenario.DurationS * 1e6));
        }

        public FrameSourceInfo Info { get; }

        public IReadOnlyList<FrameProblem> Problems => Array.Empty<FrameProblem>();

        public bool TryRead(Frame frame)
        {
            double timeS = _next / _scenario.Projector.RefreshHz;
            if (timeS >= _scenario.DurationS)
                return false;
            long clockUs = _truth.ColorClockUs(timeS * 1e6);
            frame.Begin(_next++, clockUs);
            _picture.Draw(timeS);
            frame.Color.CopyFrom(_picture.Image);
            frame.Color.TimeUs = clockUs;
            return true;
        }

        public void Dispose() => _picture.Dispose();
    }
}
