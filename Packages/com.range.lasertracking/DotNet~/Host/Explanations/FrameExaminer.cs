using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Terminal;
using LaserTracking.Imaging;
using LaserTracking.Session;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Explanations
{
    /// <summary>
    /// Runs a detector and the tracker over a stream up to one frame, as a session would, keeps everything that was examined there,
    /// and goes on for a few frames to learn what became of the dots that had to wait.
    /// </summary>
    internal sealed class FrameExaminer
    {
        /// <summary>The tracker decides within its few frames of patience; the rest is for gaps.</summary>
        private const int LaterFrames = 12;

        private readonly IShotDetector _detector;
        private readonly ShotTracker _tracker = new();
        private readonly Detections _detections = new();
        private readonly DetectionTrace _trace = new(2048);
        private readonly Dictionary<int, Shot> _shots = new();
        private ExplainedFrame? _explained;

        public FrameExaminer(IShotDetector detector)
        {
            _detector = detector;
        }

        /// <param name="source">At its beginning.</param>
        /// <param name="name">For messages.</param>
        /// <param name="index">The frame to explain, 0-based.</param>
        /// <param name="atPx">A place to look at closely; null: none.</param>
        /// <param name="progress">Says how far it is.</param>
        /// <param name="interrupted">Ends the run.</param>
        /// <exception cref="InputException">The stream has no such frame, it has no picture, or the place lies outside of it.</exception>
        public ExplainedFrame Run(IFrameSource source, string name, int index, Vector2D? atPx, ProgressLine progress, CancellationToken interrupted)
        {
            using var frame = new Frame();
            int last = -1;
            while (source.TryRead(frame))
            {
                interrupted.ThrowIfCancellationRequested();
                progress.Show(FormattableString.Invariant($"frame {frame.Index} of {index}"));
                if (_explained == null && frame.Index > index)
                    throw new InputException(name, FormattableString.Invariant($"frame {index} is missing: after frame {last} comes frame {frame.Index}"), "name a frame that is there");
                last = frame.Index;
                if (frame.Index == index)
                    Begin(frame, name, atPx);
                _detections.Begin(frame.Index, frame.TimeUs);
                _detector.Process(frame, _detections);
                if (frame.Color.IsPresent)
                    _tracker.Process(_detections);
                KeepShots();
                if (frame.Index == index)
                    Explain();
                else if (_explained != null && frame.Color.IsPresent)
                    Decide(frame.Index);
                if (_explained != null && (frame.Index >= index + LaterFrames || _explained.Candidates.All(c => c.IsDecided)))
                    break;
            }

            if (_explained == null)
                throw new InputException(name, last < 0 ? "no frame could be read" : FormattableString.Invariant($"has no frame {index}"), FormattableString.Invariant($"its frames are 0 … {last}"));
            if (_explained.Candidates.Any(c => !c.IsDecided))
            {
                _tracker.Finish();
                Decide(last);
                foreach (ExplainedCandidate candidate in _explained.Candidates.Where(c => !c.IsDecided))
                    candidate.Verdict = FormattableString.Invariant($"waits; nothing was decided until frame {last}");
            }

            return _explained;
        }

        private void Begin(Frame frame, string name, Vector2D? atPx)
        {
            if (!frame.Color.IsPresent)
                throw new InputException(name, FormattableString.Invariant($"frame {frame.Index} has no usable colour picture"), "name another frame");
            if (atPx is { } at && !(at.X >= -0.5 && at.Y >= -0.5 && at.X <= frame.Color.Width - 0.5 && at.Y <= frame.Color.Height - 0.5))
                throw new InputException("--at", FormattableString.Invariant($"{at.X:0.##},{at.Y:0.##} lies outside the picture"), FormattableString.Invariant($"x is 0 … {frame.Color.Width - 1}, y is 0 … {frame.Color.Height - 1}"));
            if (_detector is ShotDetector shots)
            {
                shots.Trace = _trace;
                _trace.Spot = atPx is { } spot ? new SpotTrace(new Vector2D(Math.Max(0, spot.X), Math.Max(0, spot.Y))) : null;
            }

            _explained = new ExplainedFrame { InputName = name, Detector = _detector.Name, Index = frame.Index, TimeUs = frame.TimeUs, Spot = _trace.Spot };
            ColorConversion.ToBgra(frame.Color, _explained.Picture);
        }

        private void KeepShots()
        {
            foreach (Shot shot in _tracker.Shots)
                _shots[shot.TrackId] = shot;
        }

        private void Explain()
        {
            if (_detector is ShotDetector shots)
            {
                foreach (ExaminedCandidate candidate in _trace.Candidates)
                    _explained!.Candidates.Add(CandidateBuilder.FromTrace(candidate, _trace, _explained.Candidates.Count + 1));
                shots.Trace = null;
            }
            else
            {
                CandidateBuilder.AddDetections(_explained!, _detections);
            }

            for (int i = 0; i < _detections.Dots.Length; i++)
                SayWhatTheTrackerSaid(_detections.Dots[i]);
            foreach (ExplainedCandidate beyond in _explained!.Candidates.Where(c => c.Verdict.Length == 0 && c.State == CandidateState.Rejected))
                beyond.Verdict = "a dot, but there was no room to note it";
            foreach (RejectedCandidate lost in _tracker.Rejected)
                _explained!.Notes.Add(FormattableString.Invariant($"the tracker gave up the dot that began at {lost.PositionPx.X:F1}, {lost.PositionPx.Y:F1}: {Words(lost)}"));
            foreach (Shot shot in _tracker.Shots)
            {
                if (shot.LastFrameIndex != _explained!.Index)
                    _explained.Notes.Add(FormattableString.Invariant($"shot {shot.Id} is reported in this frame: its light at {shot.Dot.PositionPx.X:F1}, {shot.Dot.PositionPx.Y:F1} began in frame {shot.FirstFrameIndex} and is gone"));
            }

            int unexamined = _detections.OverflowCount;
            if (unexamined > 0)
                _explained!.Notes.Add(FormattableString.Invariant($"{unexamined} more spots were left out: only so many are examined or listed in one frame"));
        }

        private void SayWhatTheTrackerSaid(in Dot dot)
        {
            Vector2D at = dot.PositionPx;
            ExplainedCandidate? candidate = _explained!.Candidates.Find(c => c.Reason == RejectionReason.None && c.PositionPx.Equals(at));
            if (candidate == null)
                return;
            candidate.State = CandidateState.Waiting;
            foreach (TrackedDot tracked in _tracker.Dots)
            {
                if (!tracked.Dot.PositionPx.Equals(at) || !_shots.TryGetValue(tracked.TrackId, out Shot shot))
                    continue;
                bool isNow = shot.FrameIndex == _explained.Index;
                candidate.State = isNow ? CandidateState.Shot : CandidateState.Dot;
                string color = EventWords.Of(shot.Dot.Color);
                candidate.Verdict = isNow
                    ? FormattableString.Invariant($"shot {shot.Id}, {color}, reported in this frame") + (shot.FirstFrameIndex < shot.FrameIndex ? FormattableString.Invariant($"; it began in frame {shot.FirstFrameIndex}") : string.Empty)
                    : FormattableString.Invariant($"goes on from shot {shot.Id}, reported in frame {shot.FrameIndex}");
                return;
            }
        }

        /// <summary>Looks whether this later frame has decided about dots that waited.</summary>
        private void Decide(int frameIndex)
        {
            double reach = new ShotTrackerSettings().LinkRadiusPx * _explained!.Picture.Width / 640.0 * 1.5;
            foreach (ExplainedCandidate candidate in _explained.Candidates.Where(c => !c.IsDecided))
            {
                double nearest = reach;
                foreach (Shot shot in _tracker.Shots)
                {
                    double distance = (shot.Dot.PositionPx - candidate.PositionPx).Length;
                    if (shot.FirstFrameIndex > _explained.Index || shot.LastFrameIndex < _explained.Index || distance >= nearest)
                        continue;
                    nearest = distance;
                    candidate.State = CandidateState.Shot;
                    candidate.Verdict = FormattableString.Invariant($"waited; shot {shot.Id}, {EventWords.Of(shot.Dot.Color)}, reported in frame {shot.FrameIndex}");
                }

                foreach (RejectedCandidate lost in _tracker.Rejected)
                {
                    double distance = (lost.PositionPx - candidate.PositionPx).Length;
                    if (distance >= nearest)
                        continue;
                    nearest = distance;
                    candidate.State = CandidateState.Waiting;
                    candidate.Verdict = FormattableString.Invariant($"waited; given up in frame {frameIndex}: {Words(lost)}");
                }
            }
        }

        private static string Words(in RejectedCandidate candidate) =>
            FormattableString.Invariant($"{EventWords.Of(candidate.Reason)} ({candidate.Value:0.###}, limit {candidate.Limit:0.###})");
    }
}
