using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Detection;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>Curves learned from labelled candidates, and what curves learned without a candidate's own clip or simulation say about it.</summary>
    internal sealed class EvidenceTraining
    {
        private const int Folds = 6;
        private const int Bins = 24;
        private const int Seed = 1;

        /// <summary>Of a dot that has been reported the growth matters less than the beginning.</summary>
        private const double LaterDotWeight = 0.5;

        /// <summary>Every second candidate that is no dot is learned from, for two.</summary>
        private const double NoDotShare = 0.5;

        private EvidenceTraining(CandidateSet set, BoostedCurves curves, IReadOnlyDictionary<int, BoostedCurves> without)
        {
            Set = set;
            Curves = curves;
            Without = without;
            LeftOut = set.Candidates.Select(c => without.TryGetValue(c.Group, out BoostedCurves? others) ? others.LogOdds(c.Features) : double.NaN).ToArray();
            InSample = set.Candidates.Select(c => curves.LogOdds(c.Features)).ToArray();
        }

        public CandidateSet Set { get; }

        public BoostedCurves Curves { get; }

        /// <summary>By group: curves that have not seen it.</summary>
        public IReadOnlyDictionary<int, BoostedCurves> Without { get; }

        /// <summary>Log-odds of each candidate by curves that have not seen its group; NaN where there is only one group.</summary>
        public double[] LeftOut { get; }

        /// <summary>Log-odds of each candidate by <see cref="Curves"/>, which have seen it.</summary>
        public double[] InSample { get; }

        /// <exception cref="InputException">There are no dots among the candidates, or nothing else.</exception>
        public static EvidenceTraining Run(CandidateSet set, StudyOptions options, CancellationToken interrupted)
        {
            IReadOnlyList<WeighedCandidate> all = set.Candidates;
            bool[] isDot = all.Select(IsDot).ToArray();
            if (!isDot.Contains(true) || !isDot.Contains(false))
                throw new InputException("range train", "among the candidates are no dots, or nothing else", "take more seeds or more cases");
            var random = new Random(Seed);
            FeatureBins bins = FeatureBins.Of(Balanced(all, random), Bins);
            float[][] features = all.Select(c => c.Features).ToArray();
            byte[][] binned = Enumerable.Range(0, bins.FeatureCount).Select(f => bins.Digitize(features, f)).ToArray();
            double[] weights = all.Select(c => Weight(c, random)).ToArray();
            var booster = new CurveBooster();
            options.Progress.Show("learning");
            BoostedCurves curves = booster.Fit(bins, binned, isDot, weights);
            var byGroup = new Dictionary<int, BoostedCurves>();
            int[] groups = all.Select(c => c.Group).Distinct().Order().ToArray();
            for (int fold = 0; fold < Math.Min(Folds, groups.Length) && groups.Length > 1 && !interrupted.IsCancellationRequested; fold++)
            {
                options.Progress.Show(FormattableString.Invariant($"learning without part {fold + 1} of {Folds}"));
                HashSet<int> without = groups.Where((_, i) => i % Folds == fold).ToHashSet();
                double[] own = weights.Select((w, i) => without.Contains(all[i].Group) ? 0 : w).ToArray();
                if (!Enumerable.Range(0, own.Length).Any(i => own[i] > 0 && isDot[i]) || !Enumerable.Range(0, own.Length).Any(i => own[i] > 0 && !isDot[i]))
                    continue;
                BoostedCurves others = booster.Fit(bins, binned, isDot, own);
                foreach (int group in without)
                    byGroup.Add(group, others);
            }

            return new EvidenceTraining(set, curves, byGroup);
        }

        public static bool IsDot(WeighedCandidate candidate) => candidate.Label != CandidateLabel.NoDot;

        private static double Weight(WeighedCandidate candidate, Random random) => candidate.Label switch
        {
            CandidateLabel.FirstDot => 1,
            CandidateLabel.LaterDot => LaterDotWeight,
            _ => random.NextDouble() < NoDotShare ? 1 / NoDotShare : 0,
        };

        /// <summary>Dots, as many others, and as many others that look like dots: steps are wanted where these differ.</summary>
        private static List<float[]> Balanced(IReadOnlyList<WeighedCandidate> all, Random random)
        {
            float[][] dots = all.Where(IsDot).Select(c => c.Features).ToArray(), others = all.Where(c => !IsDot(c)).Select(c => c.Features).ToArray();
            float[][] alike = others.Where(f => f[(int)DotFeature.LogElongation] < 1 && f[(int)DotFeature.RisenAround] < 0.01f && f[(int)DotFeature.RingShare] < 0.02f).ToArray();
            random.Shuffle(others);
            random.Shuffle(alike);
            return dots.Concat(others.Take(dots.Length)).Concat(alike.Take(dots.Length)).ToList();
        }
    }
}
