using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>Camera 1 of a simulated range: casts each frame when it is read. Frames depend on the scenario only.</summary>
    internal sealed unsafe class SimulatedDepthSource : IFrameSource
    {
        private readonly SimulationScenario _scenario;
        private readonly DepthCameraGeometry _geometry;
        private readonly FrameTiming _timing;
        private readonly DepthScene _scene;
        private readonly DepthSensor _sensor;
        private int _next;

        public SimulatedDepthSource(SimulationScenario scenario, DepthCameraGeometry geometry, ShooterMotion[] motions, FrameTiming timing)
        {
            _scenario = scenario;
            _geometry = geometry;
            _timing = timing;
            _scene = new DepthScene(scenario, geometry, motions);
            _sensor = new DepthSensor(scenario.DepthCamera, geometry);
            Info = new FrameSourceInfo(scenario.Name + " (simulation, seed " + scenario.Seed + ", depth)", geometry.Width, geometry.Height,
                scenario.DepthCamera.FramesPerSecond, (long)(scenario.DurationS * 1e6));
        }

        public FrameSourceInfo Info { get; }

        public IReadOnlyList<FrameProblem> Problems => Array.Empty<FrameProblem>();

        public bool TryRead(Frame frame)
        {
            if (_next >= _timing.Count)
                return false;
            int index = _next++, width = _geometry.Width;
            frame.Begin(index, _timing.ClockUs(index));
            frame.Depth.Reset(PixelFormat.Depth16, width, _geometry.Height, frame.TimeUs);
            int exposure = _timing.Exposure(index);
            _scene.Cast(_timing.MidUs(index) / 1e6, exposure);
            uint key = (uint)CounterRandom.Hash(_scenario.Seed, RandomStream.DepthNoise, exposure);
            fixed (float* depth = _scene.Depth)
            {
                for (int y = 0; y < _geometry.Height; y++)
                {
                    float* row = depth + y * width;
                    _sensor.MeasureRow(row, y > 0 ? row - width : row, width, (uint)(y * width), key, (ushort*)(frame.Depth.Pixels + y * frame.Depth.Stride));
                }
            }

            return true;
        }

        public void Dispose()
        {
        }
    }
}
