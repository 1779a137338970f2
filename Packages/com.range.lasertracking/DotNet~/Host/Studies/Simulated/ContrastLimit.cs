namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>The stated limit of contrast: what rises at least that far is to be found.</summary>
    internal static class ContrastLimit
    {
        /// <summary>Share of the room left to full brightness.</summary>
        public const double Rise = 0.3;

        public const double Levels = 30;

        public static bool IsAbove(TracedShot shot) => shot.Rise >= Rise && shot.RiseLevels >= Levels;
    }
}
