using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Session;

namespace LaserTracking.Pipeline
{
    /// <summary>Watches the stream itself and says once, not every frame, when something is wrong with it.</summary>
    internal sealed class PipelineHealth
    {
        private readonly PipelineSettings _settings;
        private readonly IEventSink _sink;
        private long _lastTimeUs = long.MinValue;
        private double _usualIntervalUs;
        private bool _wasBlind;
        private bool _overflowed;
        private bool _hadPicture = true;
        private readonly PredictionHealth _prediction = new PredictionHealth();

        public PipelineHealth(PipelineSettings settings, IEventSink sink)
        {
            _settings = settings;
            _sink = sink;
        }

        public void CheckFrame(Frame frame, bool hasPicture)
        {
            if (!hasPicture && _hadPicture)
                Report(frame.Index, frame.TimeUs, HealthKind.FrameGap, 1, "the picture of this frame is missing or damaged; it was skipped");
            _hadPicture = hasPicture;
            if (_lastTimeUs != long.MinValue)
            {
                long interval = frame.TimeUs - _lastTimeUs;
                if (interval <= 0)
                    Report(frame.Index, frame.TimeUs, HealthKind.FrameGap, interval * 1e-6, "time stands still or runs back; times of shots around here are doubtful");
                else if (_usualIntervalUs > 0 && interval > _usualIntervalUs * _settings.FrameGapFactor)
                    Report(frame.Index, frame.TimeUs, HealthKind.FrameGap, interval * 1e-6, "frames are missing before this one; shots fired meanwhile are lost");
                if (interval > 0)
                    _usualIntervalUs = _usualIntervalUs > 0 ? _usualIntervalUs + (Math.Min(interval, 2 * _usualIntervalUs) - _usualIntervalUs) * 0.1 : interval;
            }

            _lastTimeUs = frame.TimeUs;
        }

        public void CheckDetections(Detections detections)
        {
            if (_prediction.Check(detections) is string rendered)
                Report(detections.FrameIndex, detections.TimeUs, HealthKind.Rendered, (detections.PredictedDelayUs ?? 0) * 1e-6, rendered);
            bool isBlind = detections.BlindShare > _settings.BlindShareLimit;
            if (isBlind && !_wasBlind)
                Report(detections.FrameIndex, detections.TimeUs, HealthKind.Blind, detections.BlindShare, "too bright or too busy to see a dot in much of the picture; lower the exposure");
            _wasBlind = isBlind;
            bool overflows = detections.OverflowCount > 0;
            if (overflows && !_overflowed)
                Report(detections.FrameIndex, detections.TimeUs, HealthKind.Overflow, detections.OverflowCount, "so much changes at once that only the strongest spots are examined; a shot just now could be missed");
            _overflowed = overflows;
        }

        public void ReportInput(FrameProblem problem, long timeUs) =>
            Report(problem.FrameIndex, timeUs, HealthKind.Input, problem.Offset, problem.What);

        private void Report(int frameIndex, long timeUs, HealthKind kind, double value, string text) =>
            _sink.OnHealth(new HealthEvent { FrameIndex = frameIndex, TimeUs = timeUs, Kind = kind, Value = value, Text = text });
    }
}
