using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Session;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Sessions
{
    /// <summary>How a session on the simulated range compares with what was really fired.</summary>
    internal static class TruthComparison
    {
        private const double MatchRadiusM = 0.06;
        private const int FrameTolerance = 2;

        public static void Print(SessionRecorder session, SimulationTruth truth)
        {
            var free = new List<ShotEvent>(session.ShotsByTime());
            var pairs = new List<(TrueShot Fired, ShotEvent Seen)>();
            TrueShot[] fired = truth.Shots.Where(s => s.FirstFrame >= 0).ToArray();
            foreach (TrueShot shot in fired)
            {
                int match = Nearest(free, shot);
                if (match < 0)
                    continue;
                pairs.Add((shot, free[match]));
                free.RemoveAt(match);
            }

            int colors = pairs.Count(p => p.Seen.Shot.Dot.Color == p.Fired.Color);
            int hits = pairs.Count(p => (p.Seen.HasHit ? p.Seen.Hit.Target + p.Seen.Hit.Zone : string.Empty) == p.Fired.Target + p.Fired.Zone);
            (int right, int wrong) = CountShooters(pairs);
            Console.WriteLine(FormattableString.Invariant($"against the simulation's truth: {pairs.Count} of {fired.Length} shots found, {free.Count} false{PositionText(pairs)}"));
            Console.WriteLine(FormattableString.Invariant($"of the {pairs.Count} found: colour right {colors}, target and zone right {hits}, shooter right {right}, wrong {wrong}, unknown {pairs.Count - right - wrong}"));
        }

        private static string PositionText(List<(TrueShot Fired, ShotEvent Seen)> pairs)
        {
            double[] errorsMm = pairs.Select(p => (p.Seen.ScreenM - p.Fired.ScreenM).Length * 1000).OrderBy(e => e).ToArray();
            return errorsMm.Length == 0
                ? string.Empty
                : FormattableString.Invariant($", position off by {errorsMm[errorsMm.Length / 2]:F1} mm (median), {errorsMm[(int)(0.95 * (errorsMm.Length - 1))]:F1} mm (95 %)");
        }

        /// <summary>The session numbers shooters by their first shot: each number stands for whom it names most often.</summary>
        private static (int Right, int Wrong) CountShooters(List<(TrueShot Fired, ShotEvent Seen)> pairs)
        {
            int right = 0, known = 0;
            foreach (var ofNumber in pairs.Where(p => p.Seen.Shooter > 0).GroupBy(p => p.Seen.Shooter))
            {
                known += ofNumber.Count();
                right += ofNumber.GroupBy(p => p.Fired.Shooter).Max(g => g.Count());
            }

            return (right, known - right);
        }

        private static int Nearest(List<ShotEvent> shots, TrueShot shot)
        {
            int best = -1;
            double bestDistance = MatchRadiusM;
            for (int i = 0; i < shots.Count; i++)
            {
                double distance = (shots[i].ScreenM - shot.ScreenM).Length;
                bool isInTime = shots[i].Shot.FrameIndex >= shot.FirstFrame && shots[i].Shot.FrameIndex <= shot.LastFrame + FrameTolerance;
                if (isInTime && distance < bestDistance)
                {
                    best = i;
                    bestDistance = distance;
                }
            }

            return best;
        }
    }
}
