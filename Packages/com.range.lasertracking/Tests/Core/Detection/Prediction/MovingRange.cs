using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Detection
{
    /// <summary>A small simulated range whose whole picture moves, played through a detector that is given the rendered pictures.</summary>
    internal sealed class MovingRange
    {
        private readonly SimulatedRange _range;
        private readonly SimulatedRange _pictures;
        private readonly RenderedFrameHistory _history = new RenderedFrameHistory();

        /// <param name="scenario">Made by <see cref="Scenario"/>.</param>
        /// <param name="shown">Whose pictures the detector is given; the same range's when absent.</param>
        public MovingRange(SimulationScenario scenario, SimulationScenario? shown = null)
        {
            _range = new SimulatedRange(scenario, SimulationScenes.Empty());
            _pictures = shown == null ? _range : new SimulatedRange(shown, SimulationScenes.Empty());
            Expected = new ExpectedView(_history, _range.Calibration);
        }

        public ExpectedView Expected { get; }

        public SimulationTruth Truth => _range.Truth;

        public RangeCalibration Calibration => _range.Calibration;

        public List<Shot> Shots { get; } = new List<Shot>();

        /// <summary>By frame: how far the expected view was relied on.</summary>
        public List<PredictionState> States { get; } = new List<PredictionState>();

        /// <summary>By frame: delay measured, µs; null while unknown.</summary>
        public List<long?> DelaysUs { get; } = new List<long?>();

        /// <summary>Added to the times of drawing, µs, by camera time.</summary>
        public Func<long, long> ClockOffsetUs { get; set; } = _ => 0;

        public static SimulationScenario Scenario(int seed, double durationS, ProjectedContent content = ProjectedContent.Shapes)
        {
            var scenario = new SimulationScenario { Seed = seed, DurationS = durationS };
            scenario.DepthCamera.Enabled = false;
            scenario.ColorCamera.Width = scenario.Projector.Width = 320;
            scenario.ColorCamera.Height = scenario.Projector.Height = 180;
            scenario.Projector.Content = content;
            scenario.Shooters.Add(new ShooterSettings());
            scenario.Shooters[0].Laser.DotRadiusMm = 8;
            return scenario;
        }

        public IFrameSource CreateCamera() => _range.CreateColorSource();

        public IFrameSource CreatePictures() => _pictures.CreatePictureSource();

        /// <summary>Plays to the end; counts the dots shown, and those of them that the tracker has within 3 px in the same frame.</summary>
        public void PlayAndCount(bool useExpected, out int shown, out int seen)
        {
            int all = 0, near = 0;
            Play(useExpected, (frame, tracker) =>
            {
                foreach (TrueDot dot in Truth.DotsOf(frame.Index))
                {
                    all++;
                    foreach (TrackedDot tracked in tracker.Dots)
                        near += (tracked.Dot.PositionPx - dot.PositionPx).Length < 3 ? 1 : 0;
                }
            });
            shown = all;
            seen = near;
        }

        /// <summary>Plays to the end; the action sees each frame after it was processed, with the dots tracked in it.</summary>
        public void Play(bool useExpected = true, Action<Frame, ShotTracker>? after = null)
        {
            var detector = new ShotDetector(null, useExpected ? Expected : null);
            var tracker = new ShotTracker();
            var detections = new Detections();
            using IFrameSource camera = CreateCamera();
            using IFrameSource pictures = CreatePictures();
            using var frame = new Frame();
            using var picture = new Frame();
            bool hasPicture = pictures.TryRead(picture);
            while (camera.TryRead(frame))
            {
                for (; hasPicture && picture.TimeUs <= frame.TimeUs; hasPicture = pictures.TryRead(picture))
                    _history.Add(picture.Color, picture.TimeUs + ClockOffsetUs(picture.TimeUs));
                detector.Process(frame, detections);
                tracker.Process(detections);
                foreach (Shot shot in tracker.Shots)
                    Shots.Add(shot);
                States.Add(detections.Prediction);
                DelaysUs.Add(detections.PredictedDelayUs);
                after?.Invoke(frame, tracker);
            }
        }
    }
}
