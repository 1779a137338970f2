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
        private readonly IShotDetector _detector = new ShotDetector();
        private readonly ShotTracker _tracker = new();
        private readonly Detections _detections = new();
        private readonly Queue<Vector2D> _shiftsPx = new();

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
                Vector2D shift = _shiftsPx.ElementAt(System.Math.Max(0, _shiftsPx.Count - 1 - (shot.FrameIndex - shot.FirstFrameIndex)));
                Reported.Add(new ReportedShot(shot.FrameIndex, shot.Dot.PositionPx - shift, shot.Dot.Color.ToString().ToLowerInvariant()));
            }

            while (_shiftsPx.Count > 64)
                _shiftsPx.Dequeue();
        }

        /// <summary>What was reported beside this clip's own shots.</summary>
        public IReadOnlyList<ReportedShot> Without(TruthClip clip)
        {
            int[] taken = ShotMatcher.Match(clip, Reported);
            return Reported.Where((_, i) => taken[i] < 0).ToArray();
        }
    }
}
