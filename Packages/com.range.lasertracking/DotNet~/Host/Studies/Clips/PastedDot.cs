namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>A dot that was added to a clip.</summary>
    internal sealed record PastedDot(int FirstFrame, int Frames, int X, int Y, DotTemplate Template);
}
