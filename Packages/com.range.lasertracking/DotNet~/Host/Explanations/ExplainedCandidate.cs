using System.Collections.Generic;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Explanations
{
    /// <summary>One candidate of the explained frame with its tests and the final word on it.</summary>
    internal sealed class ExplainedCandidate
    {
        /// <summary>From 1, in the order of examination.</summary>
        public required int Number { get; init; }

        public required Vector2D PositionPx { get; init; }

        public required Vector2D SeedPx { get; init; }

        public required Vector2D TopLeftPx { get; init; }

        public required Vector2D BottomRightPx { get; init; }

        /// <summary>Where it was found: "smallest channel" …; empty where the detector does not say.</summary>
        public required string FoundIn { get; init; }

        public bool IsSmallestChannel { get; init; }

        /// <summary>In order: tests, then evidence; those with reason None only decide whether this frame alone suffices.</summary>
        public required IReadOnlyList<TestOutcome> Tests { get; init; }

        public required RejectionReason Reason { get; init; }

        public CandidateState State { get; set; }

        /// <summary>The final word, one line.</summary>
        public string Verdict { get; set; } = string.Empty;

        public bool IsDecided => State != CandidateState.Waiting || Verdict.Length > 0;

        /// <summary>The place lies in its box, or not farther than this beside it.</summary>
        public bool Covers(Vector2D placePx, double marginPx) =>
            placePx.X >= TopLeftPx.X - marginPx && placePx.X <= BottomRightPx.X + marginPx
            && placePx.Y >= TopLeftPx.Y - marginPx && placePx.Y <= BottomRightPx.Y + marginPx;
    }
}
