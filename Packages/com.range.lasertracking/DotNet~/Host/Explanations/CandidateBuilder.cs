using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Session;

namespace LaserTracking.Host.Explanations
{
    /// <summary>Makes explained candidates of what a detector left: all tests of the default one, the verdict alone of any other.</summary>
    internal static class CandidateBuilder
    {
        public static ExplainedCandidate FromTrace(in ExaminedCandidate candidate, DetectionTrace trace, int number)
        {
            string foundIn = candidate.IsAboveContent ? "brighter than the picture can be" : candidate.IsSmallestChannel ? "smallest channel" : "largest channel";
            var explained = new ExplainedCandidate
            {
                Number = number,
                PositionPx = candidate.PositionPx,
                SeedPx = candidate.SeedPx,
                TopLeftPx = candidate.TopLeftPx,
                BottomRightPx = candidate.BottomRightPx,
                FoundIn = foundIn + (candidate.IsContinued ? ", goes on from a dot of the frame before" : string.Empty),
                IsSmallestChannel = candidate.IsSmallestChannel,
                Tests = trace.TestsOf(candidate).ToArray(),
                Reason = candidate.Reason,
            };
            if (candidate.Reason != RejectionReason.None)
                explained.Verdict = Rejected(candidate.Reason, candidate.Value, candidate.Limit);
            return explained;
        }

        /// <summary>Dots first, then what was rejected.</summary>
        public static void AddDetections(ExplainedFrame frame, Detections detections)
        {
            foreach (Dot dot in detections.Dots)
            {
                double radius = Math.Sqrt(Math.Max(1, dot.AreaPx) / Math.PI);
                frame.Candidates.Add(Alone(frame, dot.PositionPx, radius, Array.Empty<TestOutcome>(), RejectionReason.None));
            }

            foreach (RejectedCandidate rejected in detections.Rejected)
            {
                var test = new TestOutcome { What = EventWords.Of(rejected.Reason), Reason = rejected.Reason, Value = rejected.Value, Limit = rejected.Limit, IsMinimum = DetectionTrace.IsMinimum(rejected.Reason), LogOdds = double.NaN };
                ExplainedCandidate candidate = Alone(frame, rejected.PositionPx, 3, new[] { test }, rejected.Reason);
                candidate.Verdict = Rejected(rejected.Reason, rejected.Value, rejected.Limit);
                frame.Candidates.Add(candidate);
            }
        }

        private static ExplainedCandidate Alone(ExplainedFrame frame, Vector2D at, double radius, TestOutcome[] tests, RejectionReason reason) => new()
        {
            Number = frame.Candidates.Count + 1,
            PositionPx = at,
            SeedPx = at,
            TopLeftPx = at - new Vector2D(radius, radius),
            BottomRightPx = at + new Vector2D(radius, radius),
            FoundIn = string.Empty,
            Tests = tests,
            Reason = reason,
        };

        private static string Rejected(RejectionReason reason, double value, double limit) =>
            $"rejected: {EventWords.Of(reason)} ({TestRow.Number(value)}, limit {TestRow.Number(limit)})";
    }
}
