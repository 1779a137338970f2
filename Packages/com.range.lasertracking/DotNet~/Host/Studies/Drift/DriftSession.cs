using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>Frames of one camera and what truly happened to it. All lengths in pixels of a picture 640 wide.</summary>
    /// <param name="Name">For the notes.</param>
    /// <param name="Frames">In order; each is valid until the next.</param>
    /// <param name="Watches">The rows of the table that it counts for, each with the outline of the screen that is known there; null: none is.</param>
    /// <param name="FromS">When the camera begins to move; infinite: never.</param>
    /// <param name="DueS">When two pixels are reached: from then on five seconds remain.</param>
    /// <param name="MovedPx">Where it ends.</param>
    /// <param name="IsGradual">It takes its time, and may be said in parts.</param>
    internal sealed record DriftSession(string Name, IEnumerable<Frame> Frames, (string Row, Vector2D[]? OutlinePx)[] Watches, double FromS, double DueS, Vector2D MovedPx, bool IsGradual)
    {
        public bool Moves => !double.IsInfinity(FromS);
    }
}
