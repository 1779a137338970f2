using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Scoring
{
    /// <summary>One true shot: frames that show it and where it may be found.</summary>
    internal sealed record TruthShot(string Id, string? Color, int FirstVisibleFrame, int LastVisibleFrame, IReadOnlyList<Vector2D> PlacesPx);
}
