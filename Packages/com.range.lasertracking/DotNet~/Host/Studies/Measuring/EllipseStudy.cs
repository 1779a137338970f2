using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>How often a shot's ellipse holds the place where its light began.</summary>
    internal sealed class EllipseStudy : IStudy
    {
        private static readonly (string Name, Func<MeasuredShot, bool> Holds)[] Classes =
        {
            ("all", _ => true),
            ("round", s => !s.IsStreak),
            ("streak", s => s.IsStreak),
            ("saturated", s => s.IsSaturated),
            ("not saturated", s => !s.IsSaturated),
            ("first frame partly lit", s => s.IsPartlyLit),
            ("lit before the shutter opened", s => !s.IsPartlyLit),
            ("reported at once", s => s.Seen.FrameIndex == s.Seen.FirstFrameIndex),
            ("reported later", s => s.Seen.FrameIndex != s.Seen.FirstFrameIndex),
        };

        public string Name => "ellipses";

        public string What => "share of simulated shots whose 50, 90 and 95 % ellipses hold the place where the light began";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("Simulated shots: the place where the light began against the reported ellipse",
                "class", "in 50 %", "in 90 %", "in 95 %", "median error px", "p95 px", "median sigma px");
            List<MeasuredShot> told = new(), untold = new();
            Collect(options, told, untold, interrupted);
            foreach ((string name, Func<MeasuredShot, bool> holds) in Classes)
                AddRow(table, name, told.Where(holds).ToArray());
            foreach (string range in told.Select(s => s.Range).Distinct())
                AddRow(table, range, told.Where(s => s.Range == range).ToArray());
            AddRow(table, "all, shutter not told", untold.ToArray());
            table.Notes.Add("A streak reported at once has its place half-way: nothing in one frame tells which end came first, and the ellipse holds both.");
            return table;
        }

        private static void Collect(StudyOptions options, List<MeasuredShot> told, List<MeasuredShot> untold, CancellationToken interrupted)
        {
            foreach (string name in MeasuredRange.Names.Where(options.Includes))
            {
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(name + ", seed " + seed);
                    ShotCollector.Collect(MeasuredRange.Create(name, seed), told, untold, interrupted);
                }
            }
        }

        private static void AddRow(StudyTable table, string name, MeasuredShot[] shots)
        {
            if (shots.Length == 0)
                return;
            Proportion Inside(double share) => new(shots.Count(s => Ellipses.Holds(s.Seen.Dot.CovariancePx, s.ErrorPx, share)), shots.Length);
            double[] errors = shots.Select(s => s.ErrorPx.Length).OrderBy(e => e).ToArray();
            double[] sigmas = shots.Select(s => s.Seen.Dot.CovariancePx.Sigma).OrderBy(e => e).ToArray();
            table.Add(name, Inside(0.5), Inside(0.9), Inside(0.95), errors[errors.Length / 2], errors[(int)(0.95 * (errors.Length - 1))], sigmas[sigmas.Length / 2]);
        }
    }
}
