namespace LaserTracking.Hands
{
    /// <summary>Which of a person's hands; Unknown rather than a guess.</summary>
    public enum HandSide : byte
    {
        Unknown = 0,
        Left = 1,
        Right = 2,
    }
}
