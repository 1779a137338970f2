using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>One detector with its tracker on one clip; keeps what it reports.</summary>
    internal sealed class ClipRun
    {
        /// <summary>A candidate at this distance from a missed shot was it.</summary>
        private const double NearPx = 12;

        private readonly IShotDetector _detector;
        private readonly ShotTracker _tracker = new();
        private readonly Detections _detections = new();
        private readonly Queue<Vector2D> _shiftsPx = new();
        private readonly List<(int Frame, RejectedCandidate Candidate)> _rejected = new();

        /// <param name="settings">The detector's; its defaults when absent.</param>
        public ClipRun(ShotDetectorSettings? settings = null) => _detector = new ShotDetector(settings);

        public List<ReportedShot> Reported { get; } = new();

        /// <param name="frame">The next frame.</param>
        /// <param name="shiftPx">By how much its picture was displaced on purpose; taken off again.</param>
        public void Process(Frame frame, Vector2D shiftPx)
        {
            _shiftsPx.Enqueue(shiftPx);
            _detector.Process(frame, _detections);
            _tracker.Process(_detections);
            foreach (Shot shot in _tracker.Shots)
            {
                // A late report speaks of an earlier frame.
                Vector2D shift = _shiftsPx.ElementAt(Math.Max(0, _shiftsPx.Count - 1 - (shot.FrameIndex - shot.FirstFrameIndex)));
                Reported.Add(new ReportedShot(shot.FrameIndex, shot.Dot.PositionPx - shift, shot.Dot.Color.ToString().ToLowerInvariant(), shot.Dot.Confidence));
            }

            Keep(frame.Index, _detections.Rejected, shiftPx);
            Keep(frame.Index, _tracker.Rejected, shiftPx);
            while (_shiftsPx.Count > 64)
                _shiftsPx.Dequeue();
        }

        /// <summary>Why nothing was reported there: the test that the nearest candidate failed, or that there was none.</summary>
        public string WhyNot(TruthShot shot)
        {
            string? why = null;
            double nearest = NearPx;
            foreach ((int frame, RejectedCandidate candidate) in _rejected)
            {
                double away = shot.PlacesPx.Min(place => (place - candidate.PositionPx).Length);
                if (frame < shot.FirstVisibleFrame || frame > shot.LastVisibleFrame + 2 || away >= nearest)
                    continue;
                nearest = away;
                why = FormattableString.Invariant($"{candidate.Reason} {candidate.Value:G3} against {candidate.Limit:G3}");
            }

            return why ?? "no candidate";
        }

        private void Keep(int frame, ReadOnlySpan<RejectedCandidate> rejected, Vector2D shiftPx)
        {
            foreach (RejectedCandidate candidate in rejected)
            {
                RejectedCandidate kept = candidate;
                kept.PositionPx -= shiftPx;
                _rejected.Add((frame, kept));
            }
        }

        /// <summary>What was reported beside this clip's own shots.</summary>
        public IReadOnlyList<ReportedShot> Without(TruthClip clip)
        {
            int[] taken = ShotMatcher.Match(clip, Reported);
            return Reported.Where((_, i) => taken[i] < 0).ToArray();
        }
    }
}
