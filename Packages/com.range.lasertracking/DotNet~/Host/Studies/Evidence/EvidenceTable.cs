using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>How well log-odds tell dots from the rest: by curves that never saw a candidate's clip, by those learned, by those the program has.</summary>
    internal static class EvidenceTable
    {
        /// <summary>Calibration looks at steps of one between these log-odds; beyond, nearly all is decided.</summary>
        private const int Decided = 5;

        public static StudyTable Of(EvidenceTraining training)
        {
            CandidateSet set = training.Set;
            var limits = new ShotDetectorSettings();
            var table = new StudyTable(FormattableString.Invariant($"Evidence: {set.Candidates.Count(EvidenceTraining.IsDot)} candidates are dots, {set.Candidates.Count(c => !EvidenceTraining.IsDot(c))} are none"),
                "case", "log-odds above", "no dots, left out", "no dots, learned", "no dots, program's", "dots, left out", "dots, learned", "dots, program's");
            double[] program = set.Candidates.Select(c => c.LogOdds).ToArray();
            foreach (double limit in new[] { -2, limits.MinLogOdds, limits.ConclusiveLogOdds, 4, 6 })
                AddRow(table, "all", limit, training, program, _ => true);
            for (int i = 0; i < set.Cases.Count; i++)
            {
                int own = i;
                foreach (double limit in new[] { limits.MinLogOdds, limits.ConclusiveLogOdds })
                    AddRow(table, set.Cases[i], limit, training, program, c => c.Case == own);
            }

            table.Notes.Add("no dots: candidates above; dots: true shots whose first frame gave a candidate above, of those whose first frame gave any");
            table.Notes.Add("left out: by curves learned without the candidate's clip or simulation; learned: by the new curves, which saw it; program's: by the curves the program was built with, which may have seen it");
            if (!set.HasClips)
                table.Notes.Add("the recorded clips are not there: learned and judged from simulated ranges alone");
            AddCalibration(table, set.Candidates, training.LeftOut, "left out");
            AddCalibration(table, set.Candidates, program, "program's");
            return table;
        }

        private static void AddRow(StudyTable table, string name, double limit, EvidenceTraining training, double[] program, Func<WeighedCandidate, bool> isMeant)
        {
            IReadOnlyList<WeighedCandidate> all = training.Set.Candidates;
            int[] meant = Enumerable.Range(0, all.Count).Where(i => isMeant(all[i])).ToArray();

            // Nothing was left out where there is only one clip or simulation.
            object NoDots(double[] logOdds) => meant.Any(i => double.IsNaN(logOdds[i])) ? double.NaN : meant.Count(i => all[i].Label == CandidateLabel.NoDot && logOdds[i] > limit);
            Proportion Dots(double[] logOdds)
            {
                if (meant.Any(i => double.IsNaN(logOdds[i])))
                    return new Proportion(0, 0);
                bool[] found = meant.Where(i => all[i].Label == CandidateLabel.FirstDot).GroupBy(i => (all[i].Case, all[i].Group, all[i].Shot)).Select(shot => shot.Any(i => logOdds[i] > limit)).ToArray();
                return new Proportion(found.Count(f => f), found.Length);
            }

            table.Add(name, limit, NoDots(training.LeftOut), NoDots(training.InSample), NoDots(program), Dots(training.LeftOut), Dots(training.InSample), Dots(program));
        }

        /// <summary>Expected calibration error (Naeini et al., AAAI 2015): mean over the bins of |share of dots − mean probability|, weighted by their candidates.</summary>
        private static void AddCalibration(StudyTable table, IReadOnlyList<WeighedCandidate> all, double[] logOdds, string name)
        {
            int[] known = Enumerable.Range(0, all.Count).Where(i => !double.IsNaN(logOdds[i])).ToArray();
            var bins = known.GroupBy(i => (int)Math.Clamp(Math.Floor(logOdds[i]), -Decided - 1, Decided)).OrderBy(b => b.Key)
                .Select(b => (Step: b.Key, Count: b.Count(), Share: b.Count(i => EvidenceTraining.IsDot(all[i])) / (double)b.Count(), Said: b.Average(i => 1 / (1 + Math.Exp(-logOdds[i]))))).ToArray();
            double Error(bool all) => bins.Where(b => all || Math.Abs(b.Step + 0.5) < Decided).Select(b => (b.Count, Off: Math.Abs(b.Share - b.Said))).ToArray() is { Length: > 0 } some
                ? some.Sum(b => b.Count * b.Off) / some.Sum(b => b.Count)
                : double.NaN;
            if (bins.Length == 0)
                return;
            table.Notes.Add(FormattableString.Invariant($"expected calibration error, {name}: {100 * Error(true):F2} % of all, {100 * Error(false):F1} % of those between {-Decided} and {Decided}; said and true share by log-odds: ")
                + string.Join(", ", bins.Select(b => FormattableString.Invariant($"{b.Step}…: {100 * b.Said:F1} and {100 * b.Share:F1} % of {b.Count}"))));
        }
    }
}
