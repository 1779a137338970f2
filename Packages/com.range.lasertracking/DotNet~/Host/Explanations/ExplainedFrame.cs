using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Explanations
{
    /// <summary>One frame with everything that the detector examined in it.</summary>
    internal sealed class ExplainedFrame : IDisposable
    {
        public required string InputName { get; init; }

        public required string Detector { get; init; }

        public required int Index { get; init; }

        public required long TimeUs { get; init; }

        /// <summary>As it came, in B G R A.</summary>
        public Image Picture { get; } = new();

        public List<ExplainedCandidate> Candidates { get; } = new();

        /// <summary>What else happened in this frame, a line each.</summary>
        public List<string> Notes { get; } = new();

        /// <summary>The place that was asked for, as the detector saw it; null: the whole frame was asked for, or the detector cannot tell.</summary>
        public SpotTrace? Spot { get; init; }

        /// <summary>Distance that counts as "at" a place, px of this picture.</summary>
        public double NearPx => 6 * Math.Max(0.5, Picture.Width / 640.0);

        /// <summary>Numbers of those that tell most first: what became a shot, then what passed most tests.</summary>
        public IEnumerable<ExplainedCandidate> ByInterest() =>
            Candidates.OrderByDescending(c => c.State).ThenByDescending(c => c.Tests.Count(t => t.IsPassed)).ThenBy(c => c.Number);

        /// <summary>The candidate at the place: of those that cover it the one that got farthest, else the nearest one close by; null: none.</summary>
        public ExplainedCandidate? At(Vector2D placePx) =>
            ByInterest().FirstOrDefault(c => c.Covers(placePx, 2))
            ?? Candidates.Where(c => c.Covers(placePx, NearPx)).MinBy(c => (c.PositionPx - placePx).LengthSquared);

        public ExplainedCandidate? Nearest(Vector2D placePx) => Candidates.MinBy(c => (c.PositionPx - placePx).LengthSquared);

        public void Dispose() => Picture.Dispose();
    }
}
