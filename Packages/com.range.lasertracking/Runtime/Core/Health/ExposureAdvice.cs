using System;

namespace LaserTracking.Health
{
    /// <summary>By how much to change the exposure, in words: as a time where the present one is known, else as a share of it.</summary>
    internal static class ExposureAdvice
    {
        /// <summary>From here on a level may be clipped, and how far cannot be seen.</summary>
        private const double ClippedLevel = 250;

        /// <summary>Factor on the exposure that brings a level to the wanted one.</summary>
        public static double Factor(PictureMonitorSettings settings, double level) =>
            Math.Pow(settings.WantedLevel / Math.Max(1, level), settings.Gamma);

        /// <summary>"lower the exposure to 31 % of what it is", "… to 5.2 ms", "… to a quarter of what it is or less".</summary>
        public static string Text(PictureMonitorSettings settings, double level)
        {
            double factor = Factor(settings, Math.Min(255, level));
            string verb = factor < 1 ? "lower the exposure to " : "raise the exposure to ";
            string bound = level >= ClippedLevel ? " or less" : string.Empty;
            if (settings.ExposureUs > 0)
                return verb + FormattableString.Invariant($"{Round(settings.ExposureUs * factor / 1000)} ms") + bound;
            return factor > 2
                ? verb + FormattableString.Invariant($"{Math.Min(50, Math.Round(factor))} times what it is")
                : verb + FormattableString.Invariant($"{Math.Round(factor * 100)} % of what it is") + bound;
        }

        private static double Round(double milliseconds) => Math.Round(milliseconds, milliseconds < 10 ? 1 : 0);
    }
}
