namespace LaserTracking.Detection
{
    /// <summary>How long light that is not conclusive is waited for: flashes have a duration, and slow cameras see few frames of it.</summary>
    internal static class WaitLimit
    {
        /// <summary>However slowly a camera's clock runs, so many frames are enough.</summary>
        private const int MostFrames = 60;

        /// <param name="frames">Since the light began.</param>
        /// <param name="elapsedUs">The same in time.</param>
        /// <param name="leastFrames">Waited for at any rate.</param>
        /// <param name="leastUs">Waited for where that is longer.</param>
        public static bool IsOver(int frames, long elapsedUs, int leastFrames, long leastUs) =>
            frames > leastFrames && (elapsedUs > leastUs || frames > MostFrames);

        /// <summary>Frames that a camera at this interval gives within the limit.</summary>
        public static int FramesAt(double intervalUs, int leastFrames, long leastUs) =>
            intervalUs > 0 ? (int)System.Math.Max(leastFrames, System.Math.Min(MostFrames, leastUs / intervalUs)) : leastFrames;
    }
}
