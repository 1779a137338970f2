namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>A dot's confidence and whether it is a laser.</summary>
    internal sealed record JudgedDot(double Confidence, bool IsLaser);
}
