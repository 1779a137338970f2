namespace LaserTracking.Remote
{
    /// <summary>The machine's wall clock. Only what crosses machines is judged by it; results never are. Any thread.</summary>
    public interface IClock
    {
        /// <summary>Microseconds since 1970-01-01 UTC.</summary>
        long NowUs { get; }
    }
}
