using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Explanations
{
    /// <summary>Says why there is no candidate at a place: what rose there, and what kept it from being examined.</summary>
    internal static class SpotReason
    {
        /// <summary>The reason in one line first, then the measured values.</summary>
        public static List<string> Lines(ExplainedFrame frame, Vector2D atPx)
        {
            var lines = new List<string>();
            if (frame.Spot is not { } spot)
                lines.Add($"the detector {frame.Detector} names only what it listed; nothing is listed there");
            else if (!spot.IsSearched)
                lines.Add("nothing was searched in this frame: the detector learns the picture from the first frames");
            else
                Explain(frame, spot, lines);
            if (frame.Nearest(atPx) is { } nearest)
                lines.Add(FormattableString.Invariant($"the nearest candidate is #{nearest.Number} at {nearest.PositionPx.X:F1}, {nearest.PositionPx.Y:F1}, {(nearest.PositionPx - atPx).Length:F0} px away"));
            return lines;
        }

        private static void Explain(ExplainedFrame frame, SpotTrace spot, List<string> lines)
        {
            (string Name, SpotPlane Plane)[] planes = { ("smallest channel", spot.Smallest), ("largest channel", spot.Largest) };
            ExplainedCandidate[] inTile = InTile(frame, spot);
            lines.Add(Summary(spot, planes.Select(p => p.Plane).ToArray(), inTile));
            foreach ((string name, SpotPlane plane) in planes)
            {
                lines.Add(FormattableString.Invariant($"{name}: {plane.Level} levels where its past explains {plane.Envelope}: rise {plane.RiseLevels}, {plane.Rise:0.###} of the room left (highest near by, at {plane.PeakPx.X:0.#}, {plane.PeakPx.Y:0.#})"));
                lines.Add(FormattableString.Invariant($"  beyond a sixteenth of the room its tile rose by {plane.TileOnset}, gate {plane.TileGate} (of late {plane.TileActivity:0.#}): ") + Tile(plane));
            }

            lines.Add(spot.ContentLimit > 255
                ? "brighter than the picture can be: says nothing here, the picture itself is near full brightness"
                : FormattableString.Invariant($"brighter than the picture can be: {spot.Largest.Level} of at least {spot.ContentLimit}"));
        }

        private static string Summary(SpotTrace spot, SpotPlane[] planes, ExplainedCandidate[] inTile)
        {
            if (spot.IsLit)
                return "lit by a dot found in this frame: nothing further is looked for in its light";
            if (planes.All(p => p.RiseLevels <= 0))
                return "nothing rose there: it is as bright as its own past explains, or darker";
            if (planes.All(p => p.TileOnset <= p.TileGate))
                return "too faint for its tile: no rise there exceeds the tile's gate";
            if (planes.All(p => p.TileOnset <= p.TileGate || !p.IsTileExamined))
                return "too many candidates: its tile was hot, but others rose higher above their gates and only so many are examined";
            return inTile.Length > 0
                ? "taken by another: its tile was looked into, and higher rises there made " + string.Join(", ", inTile.Select(c => FormattableString.Invariant($"candidate #{c.Number}")))
                : "taken by another: its tile was looked into, and what rose there belongs to candidates that reach into it";
        }

        private static string Tile(in SpotPlane plane) => plane.TileOnset <= plane.TileGate ? "not hot"
            : plane.IsTileExamined ? "hot, looked into"
            : FormattableString.Invariant($"hot, but not among the strongest of {plane.HotTiles}");

        private static ExplainedCandidate[] InTile(ExplainedFrame frame, SpotTrace spot)
        {
            double side = 16.0 * spot.Factor;
            (double X, double Y) Tile(Vector2D at) => (Math.Floor((at.X + 0.5) / side), Math.Floor((at.Y + 0.5) / side));
            return frame.Candidates.Where(c => Tile(c.SeedPx) == Tile(spot.AtPx)).ToArray();
        }
    }
}
