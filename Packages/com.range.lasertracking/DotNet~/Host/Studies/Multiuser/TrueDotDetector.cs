using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>Camera 0 and a detector that never errs: the frames of a simulated range without pictures, and their dots from the truth.</summary>
    internal sealed class TrueDotDetector(SimulatedRange range) : IShotDetector, IFrameSource
    {
        private static readonly Covariance2D PlaceError = new(0.04, 0, 0.04);

        private int _next;

        public string Name => "truth";

        public FrameSourceInfo Info { get; } = new(range.Scenario.Name, range.Scenario.ColorCamera.Width, range.Scenario.ColorCamera.Height,
            range.Scenario.ColorCamera.FramesPerSecond, (long)(range.Scenario.DurationS * 1e6));

        public IReadOnlyList<FrameProblem> Problems => [];

        public bool TryRead(Frame frame)
        {
            if (_next >= range.Truth.ColorFrameCount)
                return false;
            frame.Begin(_next, range.Truth.ColorClockUs(range.Truth.ColorFrameTimeUs(_next)));
            _next++;
            return true;
        }

        public void Process(Frame frame, Detections detections)
        {
            detections.ImageWidthPx = range.Scenario.ColorCamera.Width;
            detections.ImageHeightPx = range.Scenario.ColorCamera.Height;
            foreach (TrueDot dot in range.Truth.DotsOf(frame.Index))
            {
                TrueShot shot = range.Truth.Shots[dot.ShotId - 1];
                detections.Add(new Dot
                {
                    PositionPx = dot.PositionPx,
                    CovariancePx = PlaceError,
                    ShapePx = PlaceError,
                    StreakPx = dot.StreakPx,
                    Peak = 255,
                    AreaPx = 9,
                    Color = shot.Color,
                    Confidence = 1,
                    IsConclusive = true,
                    IsOnset = shot.FirstFrame == frame.Index,
                });
            }
        }

        public void SetScreenPolygon(Vector2D[] cornersPx)
        {
        }

        public void Reset() => _next = 0;

        public void Dispose()
        {
        }
    }
}
