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
            int fired = 0, found = 0, colours = 0, shooters = 0, wrongShooters = 0, hits = 0;
            var errorsMm = new List<double>();
            foreach (TrueShot shot in truth.Shots.Where(s => s.FirstFrame >= 0))
            {
                fired++;
                int match = Nearest(free, shot);
                if (match < 0)
                    continue;
                ShotEvent e = free[match];
                free.RemoveAt(match);
                found++;
                errorsMm.Add((e.ScreenM - shot.ScreenM).Length * 1000);
                colours += e.Shot.Dot.Color == shot.Color ? 1 : 0;
                shooters += e.Shooter > 0 ? 1 : 0;
                hits += (e.HasHit ? e.Hit.Target + e.Hit.Zone : string.Empty) == shot.Target + shot.Zone ? 1 : 0;
            }

            errorsMm.Sort();
            string position = errorsMm.Count == 0 ? string.Empty : FormattableString.Invariant($", position off by {errorsMm[errorsMm.Count / 2]:F1} mm (median), {errorsMm[(int)(0.95 * (errorsMm.Count - 1))]:F1} mm (95 %)");
            Console.WriteLine(FormattableString.Invariant($"against the simulation's truth: {found} of {fired} shots found, {free.Count} false{position}; colour right {colours}, target and zone right {hits}, shooter known {shooters}"));
            _ = wrongShooters;
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
