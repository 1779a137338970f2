namespace LaserTracking.Host
{
    /// <summary>What the program returns to the shell.</summary>
    internal static class ExitCodes
    {
        public const int Done = 0;

        /// <summary>A check that was asked for failed.</summary>
        public const int CheckFailed = 1;

        /// <summary>Bad input or usage.</summary>
        public const int BadInput = 2;

        /// <summary>Ctrl-C; what was finished is kept.</summary>
        public const int Interrupted = 130;
    }
}
