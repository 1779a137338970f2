using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Host.Scoring
{
    /// <summary>
    /// Which reported shot is which true one. A true shot is found when one reported shot lies within 3 px (scaled by width/640) of a
    /// place of its dot and was reported in one of its frames or up to two after. The matching finds the most shots; among equals it
    /// prefers near pairs.
    /// </summary>
    internal static class ShotMatcher
    {
        private const double TolerancePx = 3;
        private const double ToleranceWidth = 640;
        private const int LateFrames = 2;

        public static double DistancePx(TruthShot shot, ReportedShot reported) => shot.PlacesPx.Min(place => (place - reported.PositionPx).Length);

        /// <summary>Kuhn's augmenting paths over the possible pairs, nearest first. Gives each reported shot's true one, or -1: false.</summary>
        public static int[] Match(TruthClip clip, IReadOnlyList<ReportedShot> reported)
        {
            double tolerance = TolerancePx * clip.Width / ToleranceWidth;
            var pairs = new List<(double Distance, int Reported)>[clip.Shots.Count];
            for (int i = 0; i < pairs.Length; i++)
            {
                TruthShot shot = clip.Shots[i];
                pairs[i] = Enumerable.Range(0, reported.Count)
                    .Where(j => shot.FirstVisibleFrame <= reported[j].Frame && reported[j].Frame <= shot.LastVisibleFrame + LateFrames)
                    .Select(j => (DistancePx(shot, reported[j]), j)).Where(pair => pair.Item1 <= tolerance).OrderBy(pair => pair).ToList();
            }

            int[] takenBy = Enumerable.Repeat(-1, reported.Count).ToArray();
            foreach (int shot in Enumerable.Range(0, pairs.Length).OrderBy(i => pairs[i].Count > 0 ? pairs[i][0].Distance : 1e9))
                Augment(shot, pairs, takenBy, new bool[reported.Count]);
            return takenBy;
        }

        private static bool Augment(int shot, List<(double Distance, int Reported)>[] pairs, int[] takenBy, bool[] seen)
        {
            foreach ((double _, int candidate) in pairs[shot])
            {
                if (seen[candidate])
                    continue;
                seen[candidate] = true;
                if (takenBy[candidate] >= 0 && !Augment(takenBy[candidate], pairs, takenBy, seen))
                    continue;
                takenBy[candidate] = shot;
                return true;
            }

            return false;
        }
    }
}
