using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>
    /// Rendered frames kept in memory and played there and back for ever, with a clock that only runs forward: a picture never
    /// jumps, and a stage can be timed without the cost of making its input.
    /// </summary>
    internal sealed class FrameLoop
    {
        private readonly List<Frame> _frames = new();
        private readonly long _periodUs;

        /// <param name="source">Read until it ends or the loop is full; disposed.</param>
        /// <param name="count">Frames to keep.</param>
        public FrameLoop(IFrameSource source, int count)
        {
            using (source)
            {
                while (_frames.Count < count)
                {
                    var frame = new Frame();
                    if (!source.TryRead(frame))
                        break;
                    _frames.Add(frame);
                }
            }

            _periodUs = (long)Math.Round(1e6 / source.Info.NominalFramesPerSecond);
        }

        /// <summary>The frame of a running number, with index and times to match.</summary>
        public Frame this[int number]
        {
            get
            {
                int turn = 2 * _frames.Count - 2;
                int place = number % turn;
                Frame frame = _frames[place < _frames.Count ? place : turn - place];
                frame.Index = number;
                frame.TimeUs = number * _periodUs;
                frame.Color.TimeUs = frame.Depth.TimeUs = frame.Infrared.TimeUs = frame.TimeUs;
                return frame;
            }
        }

        /// <summary>The moving default scene with this many lasers held on, seen by a camera of the given size and format.</summary>
        public static SimulatedRange Range(int width, int height, PixelFormat format, int lasers, double pulseMs, int everyFrames) =>
            new SimulatedRange(Scenario(width, height, format, lasers, pulseMs, everyFrames), SimulationScenes.Default());

        /// <summary>What <see cref="Range"/> simulates.</summary>
        public static SimulationScenario Scenario(int width, int height, PixelFormat format, int lasers, double pulseMs, int everyFrames)
        {
            var scenario = new SimulationScenario { Name = "benchmark", Seed = 11, DurationS = 3 };
            scenario.ColorCamera.Width = width;
            scenario.ColorCamera.Height = height;
            scenario.ColorCamera.Format = format;
            for (int i = 0; i < lasers; i++)
            {
                scenario.Shooters.Add(new ShooterSettings { OffsetXM = (i - (lasers - 1) / 2.0) * 0.65 });
                for (int frame = 5; frame < 80; frame += everyFrames)
                    scenario.Shots.Add(new ShotSettings { TimeS = frame / 30.0, Shooter = i + 1, PulseMs = pulseMs, ScreenM = new Geometry.Vector2D(0.8 + 0.7 * i, 0.6 + 0.25 * i) });
            }

            return scenario;
        }
    }
}
