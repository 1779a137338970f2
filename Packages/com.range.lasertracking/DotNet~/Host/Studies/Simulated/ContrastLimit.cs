using System;
using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>
    /// The stated limit of contrast: from it the default detector takes one frame as enough (its ConclusiveRise). Light that reaches it in
    /// all three channels is told from light that reaches it in the strongest one alone, which has to wait for its end.
    /// </summary>
    internal static class ContrastLimit
    {
        /// <summary>Share of the room left to full brightness.</summary>
        public const double Rise = 0.33;

        public static string Words => FormattableString.Invariant($"limit: a pixel risen by {100 * Rise:F0} % of the room left");

        public static string[] Columns => ["all channels above the limit: found", "the strongest alone above: found", "below: found"];

        public static bool IsAbove(TracedShot shot) => shot.RiseOfAll >= Rise;

        /// <summary>One for each column.</summary>
        public static object[] Shares(IReadOnlyCollection<TracedShot> shots) =>
            [Share(shots.Where(IsAbove)), Share(shots.Where(s => !IsAbove(s) && s.Rise >= Rise)), Share(shots.Where(s => !IsAbove(s) && s.Rise < Rise))];

        public static Proportion Share(IEnumerable<TracedShot> shots)
        {
            TracedShot[] of = shots.ToArray();
            return new Proportion(of.Count(s => s.IsFound), of.Length);
        }
    }
}
