using System;
using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>Probabilities said against how often it was so.</summary>
    internal static class CalibrationCurve
    {
        private static readonly double[] Bins = { 0, 0.5, 0.7, 0.8, 0.9, 0.95, 0.98, 0.99, 0.995, 0.999, 1.000001 };

        /// <summary>One line a bin, and the expected calibration error: the mean distance, weighted by how many there are (Guo et al. 2017).</summary>
        public static IEnumerable<string> Describe(IReadOnlyCollection<(double Said, bool IsTrue)> all)
        {
            double error = 0;
            for (int i = 0; i + 1 < Bins.Length; i++)
            {
                (double Said, bool IsTrue)[] bin = all.Where(p => p.Said >= Bins[i] && p.Said < Bins[i + 1]).ToArray();
                if (bin.Length == 0)
                    continue;
                double said = bin.Average(p => p.Said);
                var true_ = new Proportion(bin.Count(p => p.IsTrue), bin.Length);
                error += Math.Abs(said - true_.Share) * bin.Length / all.Count;
                yield return FormattableString.Invariant($"shooter_p {Bins[i]:0.###}–{Math.Min(1, Bins[i + 1]):0.###}: said {100 * said:F1} %, true {true_}");
            }

            if (all.Count > 0)
                yield return FormattableString.Invariant($"expected calibration error {error:F4} over {all.Count} named shots");
        }
    }
}
