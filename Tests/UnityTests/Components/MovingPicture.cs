using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Simulation;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>A simulated range whose whole picture moves and whose camera is live: the picture is what Unity draws, frames come 60 ms after their light.</summary>
    internal sealed class MovingPicture : IDisposable
    {
        public const double LatencyS = 0.06;

        private readonly SimulatedRange _range;
        private readonly IFrameSource _camera;
        private readonly PushedFrameSource _pushed = new PushedFrameSource(new FrameSourceInfo("moving", 320, 180, 30, null));
        private readonly Image _picture = new Image();
        private Frame _next = new Frame();
        private bool _hasNext;

        public MovingPicture(int seed, double durationS)
        {
            var scenario = new SimulationScenario { Seed = seed, DurationS = durationS };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Width = scenario.Projector.Width = 320;
            scenario.ColorCamera.Height = scenario.Projector.Height = 180;
            scenario.Projector.Content = ProjectedContent.Shapes;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shooters[0].Laser.DotRadiusMm = 8;
            for (int i = 0; 3 + 0.4 * i < durationS - 1; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 3 + 0.4 * i, PulseMs = 50, ScreenM = new Vector2D(0.4 + 0.3 * (i % 8), 0.3 + 0.2 * (i % 7)) });
            _range = new SimulatedRange(scenario, SimulationScenes.Empty());
            _camera = _range.CreateColorSource();
            _hasNext = _camera.TryRead(_next);
            Rig = new RangeRig(new StubSource(0, 0));
            Rig.SourceAsset.Live = true;
            Rig.SourceAsset.Latency = LatencyS;
            Rig.SourceAsset.Create = () => _pushed;
            Rig.Screen.Use(_range.Calibration);
            GraphicsCard.Scene = Draw;
        }

        public RangeRig Rig { get; }

        public int Shots => _range.Truth.Shots.Count;

        /// <summary>Plays at 60 frames a second until the camera has no more frames; the action comes before each.</summary>
        public void Play(Action? before = null)
        {
            Rig.Range.gameObject.SetActive(true);
            while (_hasNext)
            {
                // The reader is never more than a few frames behind, on the slowest machine too.
                while (!_pushed.HasRoom)
                    System.Threading.Thread.Sleep(1);
                before?.Invoke();
                PlayerLoop.Step(1 / 60.0);
                while (_hasNext && _next.TimeUs <= (Time.timeAsDouble - LatencyS) * 1e6)
                {
                    _pushed.Push(_next);
                    _hasNext = _camera.TryRead(_next);
                }
            }

            for (int i = 0; i < 200 && Rig.Shots.Count < Shots; i++)
            {
                System.Threading.Thread.Sleep(5);
                PlayerLoop.Step(0.001);
            }

            Rig.Range.enabled = false;
        }

        public void Dispose()
        {
            _camera.Dispose();
            _picture.Dispose();
            _next.Dispose();
        }

        /// <summary>What is drawn now, enlarged by whole numbers; rows from the bottom.</summary>
        private unsafe Color32[] Draw(int width, int height)
        {
            _range.DrawPicture(Time.timeAsDouble * 1e6, _picture);
            var drawn = new Color32[width * height];
            for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
            {
                byte* pixel = _picture.Pixels + (long)(y * _picture.Height / height) * _picture.Stride + 4 * (x * _picture.Width / width);
                drawn[(height - 1 - y) * width + x] = new Color32(pixel[2], pixel[1], pixel[0], 255);
            }

            return drawn;
        }
    }
}
