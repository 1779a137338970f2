using System;
using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>The stated limit of contrast: what rises at least that far is to be found.</summary>
    internal static class ContrastLimit
    {
        /// <summary>Share of the room left to full brightness.</summary>
        public const double Rise = 0.3;

        public const double Levels = 30;

        public static string Words => FormattableString.Invariant($"limit: a pixel risen by {100 * Rise:F0} % of the room left and by {Levels} levels");

        public static bool IsAbove(TracedShot shot) => shot.Rise >= Rise && shot.RiseLevels >= Levels;

        public static Proportion ShareAbove(IEnumerable<TracedShot> shots) => Share(shots.Where(IsAbove));

        public static Proportion ShareBelow(IEnumerable<TracedShot> shots) => Share(shots.Where(s => !IsAbove(s)));

        public static Proportion Share(IEnumerable<TracedShot> shots)
        {
            TracedShot[] of = shots.ToArray();
            return new Proportion(of.Count(s => s.IsFound), of.Length);
        }
    }
}
