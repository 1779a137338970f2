namespace LaserTracking.Remote
{
    /// <summary>A clock that a test turns.</summary>
    internal sealed class TestClock : IClock
    {
        public long NowUs { get; set; } = 1_790_000_000_000_000;
    }
}
