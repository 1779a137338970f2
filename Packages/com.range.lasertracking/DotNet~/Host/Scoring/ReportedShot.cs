using LaserTracking.Geometry;

namespace LaserTracking.Host.Scoring
{
    /// <summary>What of a reported shot counts when it is compared with the truth.</summary>
    /// <param name="Frame">In which it was reported.</param>
    /// <param name="PositionPx">Where.</param>
    /// <param name="Color">As in events.jsonl; null when the event has none.</param>
    /// <param name="Confidence">0…1.</param>
    internal sealed record ReportedShot(int Frame, Vector2D PositionPx, string? Color, double Confidence = 1);
}
