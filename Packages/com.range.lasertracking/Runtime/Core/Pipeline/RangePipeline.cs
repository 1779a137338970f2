using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Fusion;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Kernels;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Tracking;

namespace LaserTracking.Pipeline
{
    /// <summary>
    /// The way of a frame: detection → tracking → geometry → fusion → scoring → session. Owns the steps and the buffers between
    /// them and is the only place that knows them all. One thread at a time; no allocation per frame once warm. Frames of camera 1
    /// come on camera 0's clock and before the frames of camera 0 that are later; <see cref="SessionRunner"/> sees to that.
    /// </summary>
    public sealed class RangePipeline
    {
        /// <summary>A palm known worse may be another's and is not stated: 95 % of those known so lie within 56 mm.</summary>
        private const double MaxPalmSigmaMm = 20;

        private readonly PipelineSettings _settings;
        private readonly IShotDetector _detector;
        private readonly ShotTracker _tracker;
        private readonly RangeCalibration? _calibration;
        private readonly IHandTracker? _handTracker;
        private readonly ShooterAssignment? _fusion;
        private readonly ShotScorer? _scorer;
        private readonly IEventSink _sink;
        private readonly PipelineHealth _health;
        private readonly Detections _detections = new Detections();
        private readonly HandObservations _hands = new HandObservations();
        private readonly TrackShooters _trackShooters = new TrackShooters();
        private readonly FusedShot[] _fused = new FusedShot[ShotTracker.MaxShotsPerFrame];
        private readonly Vector2D[] _shotsOnScreenM = new Vector2D[ShotTracker.MaxShotsPerFrame];
        private long _sceneTimeZeroUs;
        private long _firstTimeUs;
        private long _lastTimeUs;
        private long? _lastHandsUs;
        private int _frames;
        private int _dropped;

        /// <param name="detector">Finds the dots.</param>
        /// <param name="tracker">Makes shots of them.</param>
        /// <param name="calibration">Null: shots have pixels only, no screen position, shooter or hit.</param>
        /// <param name="handTracker">Null: nobody is known to have fired.</param>
        /// <param name="fusion">Who fired; null as for the hand tracker.</param>
        /// <param name="scorer">What was hit; null: nothing is scored.</param>
        /// <param name="sink">Receives all events.</param>
        /// <param name="settings">Defaults when absent.</param>
        public RangePipeline(IShotDetector detector, ShotTracker tracker, RangeCalibration? calibration, IHandTracker? handTracker,
            ShooterAssignment? fusion, ShotScorer? scorer, IEventSink sink, PipelineSettings? settings = null)
        {
            _settings = settings ?? new PipelineSettings();
            _settings.Validate();
            _detector = detector;
            _tracker = tracker;
            _calibration = calibration;
            _handTracker = calibration?.HandCamera == null ? null : handTracker;
            _fusion = _handTracker == null ? null : fusion;
            _scorer = calibration == null ? null : scorer;
            _sink = sink;
            _health = new PipelineHealth(_settings, sink, detector, calibration?.Screen);
            if (calibration != null)
                detector.SetScreenPolygon(calibration.Screen.OutlinePx);
        }

        /// <summary>The pipeline as live, replay and simulation use it: every step with its defaults, hands and shooters where camera 1 is there.</summary>
        /// <param name="detector">Finds the dots.</param>
        /// <param name="calibration">Null: shots have pixels only.</param>
        /// <param name="hasHandCamera">Frames of camera 1 will come; used when the calibration knows where it stands.</param>
        /// <param name="scorer">What was hit; null: nothing is scored.</param>
        /// <param name="sink">Receives all events.</param>
        /// <param name="settings">Defaults when absent.</param>
        /// <param name="handModel">Makes palm and side of the hands better where camera 1 has a picture; null: depth alone. Not owned.</param>
        /// <param name="kernels">What runs the heavy kernels of the hands; this thread when absent.</param>
        public static RangePipeline CreateDefault(IShotDetector detector, RangeCalibration? calibration, bool hasHandCamera, ShotScorer? scorer,
            IEventSink sink, PipelineSettings? settings = null, HandLandmarkNetwork? handModel = null, KernelRunner? kernels = null)
        {
            var tracker = new ShotTracker(new ShotTrackerSettings { Timing = (settings ?? new PipelineSettings()).CameraTiming });
            if (!hasHandCamera || calibration == null || !(calibration.HandCamera is HandCamera camera))
                return new RangePipeline(detector, tracker, calibration, null, null, scorer, sink, settings);
            Vector2D sizeM = calibration.Screen.ScreenSizeM;
            var fusion = new ShooterAssignment(camera, new FusionSettings { ScreenAreaM2 = sizeM.X * sizeM.Y });
            IHandTracker hands = new DepthHandTracker(camera, null, kernels);
            if (handModel != null)
                hands = new LandmarkHandTracker(hands, camera.Intrinsics, handModel);
            return new RangePipeline(detector, tracker, calibration, hands, fusion, scorer, sink, settings);
        }

        /// <summary>Share of the screen, 0…1, in which the last frame could not have shown a dot: too bright, or too much moved.</summary>
        public double BlindShare => _detections.BlindShare;

        /// <summary>How much later than on camera 0's clock camera 1's frames are stamped, as estimated from the shots; microseconds.</summary>
        public long HandClockOffsetUs => _fusion?.HandClockOffsetUs ?? 0;

        /// <summary>Starts a session; once, before the first frame.</summary>
        public void Begin(SessionHeader header) => _sink.Begin(header);

        /// <summary>Takes the next frame of camera 0, the one that sees the screen.</summary>
        public void Process(Frame frame)
        {
            if (_frames == 0)
            {
                _firstTimeUs = frame.TimeUs;
                _sceneTimeZeroUs = _settings.SceneTimeZeroUs ?? frame.TimeUs;
            }

            _frames++;
            _lastTimeUs = frame.TimeUs;
            _detections.Begin(frame.Index, frame.TimeUs);
            _detector.Process(frame, _detections);

            // Which pictures a frame must hold is the detector's matter: without them it names no picture.
            bool hasPicture = _detections.ImageWidthPx > 0;
            if (!hasPicture)
                _dropped++;
            _health.CheckFrame(frame, hasPicture);
            if (_handTracker != null)
                _health.CheckHands(frame.TimeUs, _lastHandsUs ?? _firstTimeUs);
            if (hasPicture)
                _tracker.Process(_detections);
            else
                return;
            _health.CheckDetections(frame, _detections);
            ReportRejected(_detections.Rejected);
            ReportRejected(_tracker.Rejected);
            ReportShots();
            ReportDots();
            _sink.OnTimePassed(Math.Min(frame.TimeUs, _tracker.EarliestPendingTimeUs));
        }

        /// <summary>Takes the next frame of camera 1, the one that sees the trainees.</summary>
        public void ProcessHands(Frame frame)
        {
            if (_handTracker == null || !(_calibration?.HandCamera is HandCamera camera))
                return;
            // Frames without a picture come while the camera is away.
            if (frame.Depth.IsPresent)
                _lastHandsUs = frame.TimeUs - HandClockOffsetUs;
            _hands.Begin(frame.Index, frame.TimeUs);
            _handTracker.Process(frame, _hands);
            _fusion?.AddHands(_hands);
            if (_fusion != null)
                _health.CheckHandClock(_fusion.HandClockOffsetUs, _fusion.HandClockSigmaUs);
            foreach (HandObservation hand in _hands.Hands)
            {
                var observed = new HandEvent
                {
                    FrameIndex = frame.Index,
                    TimeUs = _hands.TimeUs - HandClockOffsetUs,
                    TrackId = hand.TrackId,
                    Side = hand.Side,
                    PalmM = camera.ToScreenM(hand.PalmMm),
                    PalmSigmaM = hand.SigmaMm <= MaxPalmSigmaMm ? hand.SigmaMm * Axes.MetresPerMillimetre : 0,
                    MuzzleM = camera.ToScreenM(hand.MuzzleMm),
                    DepthSource = hand.DepthSource,
                };
                _sink.OnHand(observed);
            }
        }

        /// <summary>Passes on damage that a source found in its input; it shows as health.</summary>
        public void ReportInputProblem(FrameProblem problem) => _health.ReportInput(problem, _lastTimeUs);

        /// <summary>Ends the session: what still waited is settled and reported.</summary>
        /// <param name="secondsWall">Time the run took by the host's clock.</param>
        public void End(double secondsWall)
        {
            _tracker.Finish();
            ReportRejected(_tracker.Rejected);
            ReportShots();
            _sink.End(new SessionEnd
            {
                Frames = _frames,
                Dropped = _dropped,
                SecondsMedia = (_lastTimeUs - _firstTimeUs) * 1e-6,
                SecondsWall = secondsWall,
                StartTimeUs = _frames > 0 ? _firstTimeUs : (long?)null,
            });
        }

        private void ReportShots()
        {
            ReadOnlySpan<Shot> shots = _tracker.Shots;
            if (shots.Length == 0)
                return;
            if (_calibration != null)
            {
                for (int i = 0; i < shots.Length; i++)
                    _shotsOnScreenM[i] = _calibration.Screen.ToScreenM(shots[i].Dot.PositionPx);
                _fusion?.Fuse(shots, _shotsOnScreenM, _fused);
            }

            for (int i = 0; i < shots.Length; i++)
            {
                var shot = new ShotEvent { Shot = shots[i] };
                if (_calibration != null)
                {
                    shot.HasScreenPosition = _shotsOnScreenM[i].IsFinite;
                    shot.ScreenM = _shotsOnScreenM[i];
                    shot.ScreenCovarianceMm2 = _calibration.Screen.ToScreenMm2(shots[i].Dot.PositionPx, shots[i].Dot.CovariancePx);
                    if (_fusion != null)
                        AddShooter(_fused[i], ref shot);
                    if (_scorer != null && shot.HasScreenPosition)
                        AddHit(_scorer, ref shot);
                }

                _sink.OnShot(shot);
            }
        }

        private void AddShooter(in FusedShot fused, ref ShotEvent shot)
        {
            shot.Shooter = fused.Shooter;
            shot.ShooterProbability = fused.ShooterProbability;
            shot.Hand = fused.Hand;
            shot.HasMuzzle = fused.HasMuzzle;
            shot.MuzzleM = fused.MuzzleM;
            shot.Direction = fused.Direction;
            shot.PairDeltaUs = fused.PairDeltaUs;
            _trackShooters.Set(shot.Shot.TrackId, fused.Shooter);
        }

        private void AddHit(ShotScorer scorer, ref ShotEvent shot)
        {
            double sceneTimeS = (shot.Shot.TimeUs - _sceneTimeZeroUs) * 1e-6;
            Vector3D? muzzleM = shot.HasMuzzle ? shot.MuzzleM : (Vector3D?)null;
            shot.HasHit = scorer.TryScore(shot.ScreenM, shot.ScreenCovarianceMm2, shot.Shot.Dot.Confidence, muzzleM, sceneTimeS, out shot.Hit);
        }

        private void ReportDots()
        {
            foreach (TrackedDot tracked in _tracker.Dots)
            {
                _sink.OnDot(new DotEvent
                {
                    FrameIndex = _detections.FrameIndex,
                    TimeUs = _detections.TimeUs,
                    TrackId = tracked.TrackId,
                    Dot = tracked.Dot,
                    Shooter = _trackShooters.Get(tracked.TrackId),
                });
            }
        }

        private void ReportRejected(ReadOnlySpan<RejectedCandidate> rejected)
        {
            foreach (RejectedCandidate candidate in rejected)
                _sink.OnRejected(new RejectedEvent { FrameIndex = _detections.FrameIndex, TimeUs = _detections.TimeUs, Candidate = candidate });
        }
    }
}
