using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// Makes shots of dots: one flash is one shot however many frames it lasts; a dot that stays on is one shot and from then on only
    /// a tracked dot. A conclusive dot is reported in its first frame; another one waits until it vanishes sharply or begins anew
    /// nearby. Works for any detector. The dots' numbers are those of <see cref="DotTracker"/>, which does not decide what is a shot. One
    /// thread at a time; allocates nothing once constructed. Read the spans before the next call.
    /// </summary>
    public sealed class ShotTracker
    {
        /// <summary>No call reports more shots than this.</summary>
        public const int MaxShotsPerFrame = MaxTracks;

        private const int MaxTracks = 64;

        /// <summary>What a second sight or a sharp end says for a laser, log-odds: false dots hardly ever manage either.</summary>
        private const double ProofLogOdds = 3;

        private readonly ShotTrackerSettings _settings;
        private readonly LightOrigin _origin;
        private readonly DotTrack[] _tracks = new DotTrack[MaxTracks];
        private readonly Shot[] _shots = new Shot[MaxTracks];
        private readonly TrackedDot[] _dots = new TrackedDot[MaxTracks];
        private readonly RejectedCandidate[] _rejected = new RejectedCandidate[2 * MaxTracks];
        private readonly bool[] _taken = new bool[MaxTracks];
        private readonly DotTracker _lasers;
        private readonly Vector2D[] _places = new Vector2D[MaxTracks];
        private readonly int[] _laserOfDot = new int[MaxTracks];
        private int _trackCount;
        private int _shotCount;
        private int _dotCount;
        private int _rejectedCount;
        private int _lastShotId;
        private long _previousTimeUs;
        private int _previousFrame;
        private long _intervalUs;
        private double _scale = 1;

        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public ShotTracker(ShotTrackerSettings? settings = null)
        {
            _settings = settings?.Clone() ?? new ShotTrackerSettings();
            _settings.Validate();

            // Every dot here has passed the detector's judgement.
            _lasers = new DotTracker(new DotTrackerSettings { MinHits = 1, JumpRadiusPx = _settings.LinkRadiusPx });
            _origin = new LightOrigin(_settings.Timing, _settings.HandSpeedPxPerS);
            Reset();
        }

        /// <summary>Shots reported by the last call, in the order in which their light began.</summary>
        public ReadOnlySpan<Shot> Shots => new ReadOnlySpan<Shot>(_shots, 0, _shotCount);

        /// <summary>All dots of the last frame that belong to a track whose shot has been reported.</summary>
        public ReadOnlySpan<TrackedDot> Dots => new ReadOnlySpan<TrackedDot>(_dots, 0, _dotCount);

        /// <summary>Dots that turned out in the last call to be no shot of their own.</summary>
        public ReadOnlySpan<RejectedCandidate> Rejected => new ReadOnlySpan<RejectedCandidate>(_rejected, 0, _rejectedCount);

        /// <summary>Frames of the present rate that a dot may wait for its proof.</summary>
        private int WaitFrames => WaitLimit.FramesAt(_intervalUs, _settings.MaxWaitFrames, _settings.MaxWaitUs);

        /// <summary>When the light of the oldest dot began that may yet be reported as a shot, microseconds; long.MaxValue: none waits.</summary>
        public long EarliestPendingTimeUs
        {
            get
            {
                long earliest = long.MaxValue;
                for (int i = 0; i < _trackCount; i++)
                {
                    if (!_tracks[i].IsReported)
                        earliest = Math.Min(earliest, _tracks[i].FirstTimeUs);
                }

                return earliest;
            }
        }

        /// <summary>Forgets all tracks and starts to count from 1 again.</summary>
        public void Reset()
        {
            _trackCount = _shotCount = _dotCount = _rejectedCount = 0;
            _lastShotId = 0;
            _lasers.Reset();
            _previousTimeUs = long.MinValue;
            _previousFrame = -1;
            _intervalUs = 0;
        }

        /// <summary>Takes the dots of the next frame. Times that stand still or run back only make gaps look short.</summary>
        public void Process(Detections detections)
        {
            _shotCount = _dotCount = _rejectedCount = 0;
            long interval = _previousTimeUs == long.MinValue ? 0 : Math.Max(0, detections.TimeUs - _previousTimeUs);
            if (interval > 0)
                _intervalUs = interval;
            _scale = detections.ImageWidthPx > 0 ? detections.ImageWidthPx / 640.0 : 1;
            for (int i = 0; i < _trackCount; i++)
                _tracks[i].IsSeen = false;
            NumberDots(detections);
            MatchNearestFirst(detections);
            ReadOnlySpan<Dot> dots = detections.Dots;
            for (int i = 0; i < dots.Length && i < MaxTracks; i++)
            {
                if (!_taken[i])
                    Begin(dots[i], _laserOfDot[i], detections);
            }

            SettleUnseen(detections);
            DropOld(detections.TimeUs, detections.FrameIndex);
            _previousTimeUs = detections.TimeUs;
            _previousFrame = detections.FrameIndex;
        }

        /// <summary>The stream has ended: dots still waiting for their proof have not got it.</summary>
        public void Finish()
        {
            _shotCount = _dotCount = _rejectedCount = 0;
            for (int i = 0; i < _trackCount; i++)
            {
                if (!_tracks[i].IsReported)
                    Reject(_tracks[i].First.PositionPx, RejectionReason.NotConfirmed, _tracks[i].Count, WaitFrames);
            }

            _trackCount = 0;
        }

        private void NumberDots(Detections detections)
        {
            int count = Math.Min(detections.Dots.Length, MaxTracks);
            for (int i = 0; i < count; i++)
                _places[i] = detections.Dots[i].PositionPx;
            _lasers.Process(detections.TimeUs, new ReadOnlySpan<Vector2D>(_places, 0, count), 640 * _scale, _laserOfDot);
        }

        /// <summary>Links dots to tracks by the least distance of all pairs, again and again: few of both, and no order matters.</summary>
        private void MatchNearestFirst(Detections detections)
        {
            ReadOnlySpan<Dot> dots = detections.Dots;
            Array.Clear(_taken, 0, _taken.Length);
            var path = new LightPath(_settings.LinkRadiusPx, _scale);
            while (true)
            {
                double best = double.PositiveInfinity;
                int bestDot = -1, bestTrack = -1;
                for (int t = 0; t < _trackCount; t++)
                {
                    if (_tracks[t].IsSeen)
                        continue;
                    for (int d = 0; d < dots.Length && d < MaxTracks; d++)
                    {
                        double distance = _taken[d] ? double.PositiveInfinity
                            : path.DistancePx(_tracks[t], dots[d], detections.FrameIndex, detections.TimeUs, IsHeld(_tracks[t]));
                        if (distance < best)
                        {
                            best = distance;
                            bestDot = d;
                            bestTrack = t;
                        }
                    }
                }

                if (bestDot < 0)
                    return;
                _taken[bestDot] = true;
                Continue(ref _tracks[bestTrack], dots[bestDot], _laserOfDot[bestDot], detections);
            }
        }

        private void Continue(ref DotTrack track, in Dot dot, int laser, Detections detections)
        {
            track.Id = laser;
            if (IsTap(track, dot, detections))
            {
                // The old flash ended in the dark frame between.
                track = NewTrack(dot, detections, laser);
            }
            else
            {
                if (track.IsReported && dot.IsOnset && detections.FrameIndex - track.LastFrame >= 2)
                    Reject(dot.PositionPx, RejectionReason.Duplicate, (dot.PositionPx - track.LastPx).Length, _settings.LinkRadiusPx);
                if (detections.TimeUs > track.LastTimeUs)
                    track.VelocityPxPerUs = (dot.PositionPx - track.LastPx) * (1.0 / (detections.TimeUs - track.LastTimeUs));
                track.LastPx = dot.PositionPx;
                track.LastShapePx = dot.ShapePx;
                track.LastFrame = detections.FrameIndex;
                track.LastTimeUs = detections.TimeUs;
                track.Count++;
                if (track.First.Color == LaserColor.Unknown)
                    track.First.Color = dot.Color;
            }

            track.IsSeen = true;
            if (!track.IsReported && dot.IsConclusive && !IsBesideAnother(track, out double _))
                Report(ref track, detections.FrameIndex);
            if (track.IsReported && _dotCount < MaxTracks)
                _dots[_dotCount++] = new TrackedDot(track.Id, dot);
        }

        private bool IsTap(in DotTrack track, in Dot dot, Detections detections)
        {
            if (!track.IsReported || !dot.IsOnset || detections.FrameIndex - track.LastFrame < 2 || IsHeld(track))
                return false;
            long darkUs = detections.TimeUs - track.LastTimeUs;
            bool isLate = _origin.RowTimeUs(detections, dot) - track.FirstTimeUs >= _settings.MinTapPeriodUs;
            return darkUs >= (isLate ? _settings.MinTapGapUs / 2 : _settings.MinTapGapUs);
        }

        private void Begin(in Dot dot, int laser, Detections detections)
        {
            if (_trackCount == MaxTracks)
            {
                Reject(dot.PositionPx, RejectionReason.NotConfirmed, MaxTracks, MaxTracks);
                return;
            }

            Vector2D velocity = VelocityFromLost(dot, detections);
            ref DotTrack track = ref _tracks[_trackCount++];
            track = NewTrack(dot, detections, laser);
            track.VelocityPxPerUs = velocity;
            track.IsSeen = true;
            if (!dot.IsConclusive)
                return;
            Report(ref track, detections.FrameIndex);
            if (_dotCount < MaxTracks)
                _dots[_dotCount++] = new TrackedDot(track.Id, dot);
        }

        /// <summary>Should this be the light that went out as it began, farther than one flash tells, the next frame will show it as far again.</summary>
        private Vector2D VelocityFromLost(in Dot dot, Detections detections)
        {
            Vector2D nearest = default;
            double best = LightPath.MaxWayPx * _scale;
            for (int i = 0; i < _trackCount; i++)
            {
                Vector2D step = dot.PositionPx - _tracks[i].LastPx;
                if (_tracks[i].IsSeen || _tracks[i].LastFrame != _previousFrame || detections.TimeUs <= _tracks[i].LastTimeUs || step.Length > best)
                    continue;
                best = step.Length;
                nearest = step * (1.0 / (detections.TimeUs - _tracks[i].LastTimeUs));
            }

            return nearest;
        }

        private DotTrack NewTrack(in Dot dot, Detections detections, int id) => new DotTrack
        {
            Id = id,
            First = dot,
            FirstFrame = detections.FrameIndex,
            FirstTimeUs = _origin.RowTimeUs(detections, dot),
            FirstIntervalUs = _intervalUs,
            LastPx = dot.PositionPx,
            LastShapePx = dot.ShapePx,
            LastFrame = detections.FrameIndex,
            LastTimeUs = detections.TimeUs,
            Count = 1,
        };

        /// <summary>A waiting dot that is gone without a trace was a flash; one that left something behind, or stays too long, was not.</summary>
        private void SettleUnseen(Detections detections)
        {
            int kept = 0;
            for (int i = 0; i < _trackCount; i++)
            {
                ref DotTrack track = ref _tracks[i];
                bool isWaiting = !track.IsReported;
                bool isOverdue = isWaiting
                    && WaitLimit.IsOver(detections.FrameIndex - track.FirstFrame, detections.TimeUs - track.FirstTimeUs, _settings.MaxWaitFrames, _settings.MaxWaitUs);
                if (isWaiting && !isOverdue && !track.IsSeen && track.LastFrame == _previousFrame)
                {
                    double tracePx = NearestTracePx(detections, track.LastPx, out double glowPx);
                    bool isGone = detections.ImageWidthPx > 0 && tracePx > _settings.VanishRadiusPx * _scale;
                    if (!isGone)
                        isWaiting = !Drop(track, detections.FrameIndex - track.FirstFrame);
                    else if (glowPx <= _settings.VanishRadiusPx * _scale)
                        track.LastFrame = detections.FrameIndex;
                    else if (IsBesideAnother(track, out double besidePx))
                    {
                        Reject(track.First.PositionPx, RejectionReason.Duplicate, besidePx, _settings.HaloRadiusPx * _scale);
                        isWaiting = false;
                    }
                    else
                        Report(ref track, detections.FrameIndex);
                }
                else if (track.IsReported && !track.IsSeen && track.LastFrame == _previousFrame && track.LastTimeUs - track.FirstTimeUs > _settings.CoveredAfterUs)
                {
                    double tracePx = NearestTracePx(detections, track.LastPx, out double glowPx);
                    track.IsCovered = Math.Min(tracePx, glowPx) <= 2 * _settings.VanishRadiusPx * _scale;
                }
                else if (isOverdue)
                {
                    isWaiting = !Drop(track, detections.FrameIndex - track.FirstFrame);
                }

                if (isWaiting || track.IsReported)
                    _tracks[kept++] = track;
            }

            _trackCount = kept;
        }

        /// <summary>The halo of a shot of the same moment, or its faint first light; two at once so near would be strong both.</summary>
        private bool IsBesideAnother(in DotTrack track, out double distancePx)
        {
            for (int i = 0; i < _trackCount; i++)
            {
                distancePx = (_tracks[i].First.PositionPx - track.First.PositionPx).Length;
                if (_tracks[i].IsReported && Math.Abs(_tracks[i].FirstFrame - track.FirstFrame) <= 2 && distancePx <= _settings.HaloRadiusPx * _scale)
                    return true;
            }

            distancePx = double.PositiveInfinity;
            return false;
        }

        private bool Drop(in DotTrack track, int frames)
        {
            Reject(track.First.PositionPx, RejectionReason.NotConfirmed, frames, WaitFrames);
            return true;
        }

        /// <summary>Nearest candidate that says the light was none, and nearest one that is neither new nor going out: light that goes on, too weak to be a dot.</summary>
        private static double NearestTracePx(Detections detections, Vector2D at, out double glowPx)
        {
            double nearest = glowPx = double.PositiveInfinity;
            foreach (RejectedCandidate candidate in detections.Rejected)
            {
                // What grows dimmer is on its way out, and what is too faint is nothing.
                if (candidate.Reason == RejectionReason.TooFaint || candidate.Reason == RejectionReason.TooSmall)
                    continue;
                double distance = (candidate.PositionPx - at).Length;
                if (candidate.Reason != RejectionReason.NotNew)
                    nearest = Math.Min(nearest, distance);
                else if (candidate.Value >= -0.2)
                    glowPx = Math.Min(glowPx, distance);
            }

            return nearest;
        }

        /// <summary>On for longer than any flash, or lost where things moved: when it comes back soon, something passed before it.</summary>
        private bool IsHeld(in DotTrack track) => track.IsCovered || track.LastTimeUs - track.FirstTimeUs > _settings.HeldAfterUs;

        private void DropOld(long timeUs, int frameIndex)
        {
            int kept = 0;
            for (int i = 0; i < _trackCount; i++)
            {
                bool isOver = frameIndex - _tracks[i].LastFrame > 2 && timeUs - _tracks[i].LastTimeUs > (IsHeld(_tracks[i]) ? _settings.HeldMemoryUs : _settings.MemoryUs);

                // Clocks that stand still must not keep tracks for ever.
                isOver |= frameIndex - _tracks[i].LastFrame > 60;
                if (!isOver)
                    _tracks[kept++] = _tracks[i];
            }

            _trackCount = kept;
        }

        private void Report(ref DotTrack track, int frameIndex)
        {
            track.IsReported = true;
            if (_shotCount == MaxTracks)
                return;
            Dot dot = track.First;
            if (frameIndex > track.FirstFrame && !dot.IsConclusive)
            {
                dot.Factors = ConfidenceModel.Raise(dot.Factors, ProofLogOdds);
                dot.Confidence = dot.Factors.Sum;
            }

            _origin.Place(ref dot, track.LastPx - dot.PositionPx, track.FirstIntervalUs, _scale);
            _shots[_shotCount++] = new Shot
            {
                Id = ++_lastShotId,
                FrameIndex = frameIndex,
                FirstFrameIndex = track.FirstFrame,
                LastFrameIndex = track.LastFrame,
                TimeUs = track.FirstTimeUs,
                TimeSigmaUs = _origin.SigmaUs(track.FirstIntervalUs),
                Dot = dot,
                TrackId = track.Id,
            };
        }

        private void Reject(Vector2D at, RejectionReason reason, double value, double limit)
        {
            if (_rejectedCount < _rejected.Length)
                _rejected[_rejectedCount++] = new RejectedCandidate { PositionPx = at, Reason = reason, Value = value, Limit = limit };
        }
    }
}
