using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Health;
using LaserTracking.Session;

namespace LaserTracking.Pipeline
{
    /// <summary>Watches the stream, the picture and the detector and says once, not every frame, when something is wrong.</summary>
    internal sealed class PipelineHealth
    {
        private const int RoundsOfAdvice = 3;
        private const long GapMemoryUs = 10_000_000;
        private const int GapsThatPersist = 3;
        private const long BlindAfterUs = 300_000;
        private const long OverflowAfterUs = 200_000;
        private const long SeeingAfterUs = 2_000_000;

        /// <summary>Longer than this a hand is not where it was; shots go on being paired with what was seen, up to the fusion's window.</summary>
        private const long HandsSilentUs = 500_000;

        /// <summary>An offset is said from here on; below it nobody would do anything.</summary>
        private const long HandClockUs = 15_000;

        private readonly PipelineSettings _settings;
        private readonly HealthWriter _health;
        private readonly PictureMonitor _monitor;
        private DetectionAdvisor? _advisor;
        private long _lastTimeUs = long.MinValue;
        private double _usualIntervalUs;
        private long _firstGapUs = long.MinValue;
        private long _lastGapUs;
        private int _gaps;
        private int _lost;
        private Condition _clock;
        private Condition _blind;
        private Condition _overflow;
        private Condition _noHands;
        private long _saidClockUs;
        private bool _hadPicture = true;
        private readonly PredictionHealth _prediction = new PredictionHealth();

        /// <param name="settings">Of the pipeline.</param>
        /// <param name="sink">Receives what is noticed.</param>
        /// <param name="detector">Asked what it can see; other detectors than the default one cannot be.</param>
        /// <param name="screen">Where the screen is; null: the whole picture.</param>
        public PipelineHealth(PipelineSettings settings, IEventSink sink, IShotDetector detector, ScreenGeometry? screen)
        {
            _settings = settings;
            _health = new HealthWriter(sink);
            _monitor = new PictureMonitor(sink, settings.Monitor);
            if (screen != null)
                _monitor.SetScreenPolygon(screen.OutlinePx);
            if (settings.Advisor != null && detector is ShotDetector shots)
                _advisor = new DetectionAdvisor(shots, settings.Advisor, screen);
        }

        public void CheckFrame(Frame frame, bool hasPicture)
        {
            _health.Begin(frame.Index, frame.TimeUs);
            if (!hasPicture && _hadPicture)
                _health.Say(HealthKind.FrameGap, 1, "the picture of this frame is missing or damaged; it was skipped");
            _hadPicture = hasPicture;
            if (_lastTimeUs != long.MinValue)
                CheckInterval(frame.TimeUs - _lastTimeUs);
            _lastTimeUs = frame.TimeUs;
            if (hasPicture)
                _monitor.Process(frame);
        }

        public void CheckDetections(Frame frame, Detections detections)
        {
            _health.Begin(detections.FrameIndex, detections.TimeUs);
            Advise(frame);
            if (_prediction.Check(detections) is string rendered)
                _health.Say(HealthKind.Rendered, (detections.PredictedDelayUs ?? 0) * 1e-6, rendered);
            double blind = detections.BlindShare, limit = _settings.BlindShareLimit;
            if (_blind.Update(blind > limit, blind <= 0.7 * limit, detections.TimeUs, BlindAfterUs, SeeingAfterUs))
                _health.Say(HealthKind.Blind, blind, _blind.IsOn ? BlindText(blind, detections.SaturatedShare) : FormattableString.Invariant($"a dot can be seen again in {(1 - blind) * 100:F0} % of the screen"));
            int overflow = detections.OverflowCount;
            if (_overflow.Update(overflow > 0, overflow == 0, detections.TimeUs, OverflowAfterUs, SeeingAfterUs) && _overflow.IsOn)
                _health.Say(HealthKind.Overflow, overflow, "so much changes at once that only the strongest spots are examined and faint shots are missed: lower the exposure, so that less of the picture changes");
        }

        /// <summary>Says once when camera 1 falls silent, and when it is back.</summary>
        /// <param name="timeUs">Now, on camera 0's clock.</param>
        /// <param name="lastHandsUs">Time of camera 1's last picture on that clock, or of the session's beginning.</param>
        public void CheckHands(long timeUs, long lastHandsUs)
        {
            long silentUs = timeUs - lastHandsUs;
            if (!_noHands.Update(silentUs > HandsSilentUs, silentUs <= HandsSilentUs / 2, timeUs, 0, HandsSilentUs))
                return;
            _health.Say(HealthKind.HandCamera, silentUs * 1e-6, _noHands.IsOn
                ? FormattableString.Invariant($"no picture of camera 1 for {silentUs * 1e-6:F1} s: who fires is not known meanwhile; check its cable, and that both clocks are brought together")
                : "pictures of camera 1 come again");
        }

        /// <summary>Says that camera 1's clock is off, and again when it has gone on by as much as matters.</summary>
        /// <param name="offsetUs">Camera 1's clock minus camera 0's, microseconds.</param>
        /// <param name="sigmaUs">Its standard deviation.</param>
        public void CheckHandClock(long offsetUs, long sigmaUs)
        {
            if (Math.Abs(offsetUs - _saidClockUs) < HandClockUs)
                return;
            _saidClockUs = offsetUs;
            _health.Say(HealthKind.HandClock, offsetUs * 1e-6, FormattableString.Invariant(
                $"camera 1's clock is {Math.Abs(offsetUs) * 1e-3:F0} ± {sigmaUs * 1e-3:F0} ms {(offsetUs > 0 ? "ahead of" : "behind")} camera 0's, as the shots tell; corrected from here on"));
        }

        public void ReportInput(FrameProblem problem, long timeUs)
        {
            _health.Begin(problem.FrameIndex, timeUs);
            _health.Say(HealthKind.Input, problem.Offset, problem.What);
        }

        /// <summary>Once, after a few looks at every part of the screen.</summary>
        private void Advise(Frame frame)
        {
            if (_advisor == null)
                return;
            _advisor.Look(frame);
            if (_advisor.Rounds < RoundsOfAdvice)
                return;
            DetectionAdvice advice = _advisor.Advise();
            _health.Say(HealthKind.Advice, advice.DimmestMw, advice.Sentence);
            _advisor = null;
        }

        private static string BlindText(double blind, double saturated)
        {
            double moving = blind - saturated;
            string head = FormattableString.Invariant($"a dot cannot be seen in {blind * 100:F0} % of the screen: ");
            if (saturated >= moving)
                return head + (moving < 0.05 ? "it is too bright" : FormattableString.Invariant($"{saturated * 100:F0} % is too bright, in {moving * 100:F0} % too much moves")) + "; lower the exposure";
            return head + (saturated < 0.05 ? "too much moves" : FormattableString.Invariant($"in {moving * 100:F0} % too much moves, {saturated * 100:F0} % is too bright")) + "; lower the exposure until a dot is brighter than the picture";
        }

        private void CheckInterval(long interval)
        {
            if (_clock.Update(interval <= 0, interval > 0, _health.TimeUs, 0, GapMemoryUs) && _clock.IsOn)
                _health.Say(HealthKind.FrameGap, interval * 1e-6, "time stands still or runs back; times of shots around here are doubtful");
            if (interval <= 0)
                return;
            if (_usualIntervalUs > 0 && interval > _usualIntervalUs * _settings.FrameGapFactor)
                NoteGap(interval);
            _usualIntervalUs = _usualIntervalUs > 0 ? _usualIntervalUs + (Math.Min(interval, 2 * _usualIntervalUs) - _usualIntervalUs) * 0.1 : interval;
        }

        /// <summary>The first gap is said, and once that they go on; the next only after a while without.</summary>
        private void NoteGap(long interval)
        {
            long now = _health.TimeUs;
            int lost = (int)Math.Min(int.MaxValue / 2, Math.Round(interval / _usualIntervalUs) - 1);
            if (_firstGapUs == long.MinValue || now - _lastGapUs > GapMemoryUs || now < _lastGapUs)
            {
                _firstGapUs = now;
                _gaps = _lost = 0;
            }

            _lastGapUs = now;
            _gaps++;
            _lost += lost;
            if (_gaps == 1)
                _health.Say(HealthKind.FrameGap, interval * 1e-6, FormattableString.Invariant($"{lost} frames are missing before this one; shots fired meanwhile are lost"));
            else if (_gaps == GapsThatPersist)
                _health.Say(HealthKind.FrameGap, interval * 1e-6, FormattableString.Invariant($"frames keep getting lost, {_lost} within {(now - _firstGapUs) * 1e-6:F1} s: give the camera a USB port of its own and close other programs"));
        }
    }
}
