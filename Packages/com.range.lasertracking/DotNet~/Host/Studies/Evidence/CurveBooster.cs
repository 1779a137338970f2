using System;
using System.Linq;
using System.Threading.Tasks;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>
    /// Gradient boosting of logistic loss with trees of one split (Friedman, Annals of Statistics 29, 2001), leaves by Newton's step with
    /// an L2 penalty (Chen and Guestrin, KDD 2016, equations 5 to 7): each round moves two levels of one feature's curve. The same
    /// samples give the same curves.
    /// </summary>
    internal sealed class CurveBooster
    {
        public int Rounds { get; init; } = 400;

        /// <summary>Share of Newton's step taken each round.</summary>
        public double Rate { get; init; } = 0.15;

        /// <summary>Penalty on a leaf's square, in units of the hessian.</summary>
        public double Penalty { get; init; } = 20;

        /// <summary>A side of a split needs so much weighted variance.</summary>
        public double LeastHessian { get; init; } = 10;

        /// <param name="bins">The features' bins.</param>
        /// <param name="binned">Each feature's bin of every sample.</param>
        /// <param name="isDot">Of every sample.</param>
        /// <param name="weights">Of every sample, positive; zero: left out.</param>
        /// <exception cref="ArgumentException">There are no dots, or nothing else.</exception>
        public BoostedCurves Fit(FeatureBins bins, byte[][] binned, bool[] isDot, double[] weights)
        {
            int[] used = Enumerable.Range(0, isDot.Length).Where(i => weights[i] > 0).ToArray();
            double dots = used.Where(i => isDot[i]).Sum(i => weights[i]), others = used.Where(i => !isDot[i]).Sum(i => weights[i]);
            if (!(dots > 0) || !(others > 0))
                throw new ArgumentException("there must be dots and others to tell apart");
            double baseLogOdds = Math.Log(dots / others);
            double[] logOdds = Enumerable.Repeat(baseLogOdds, used.Length).ToArray(), gradient = new double[used.Length], hessian = new double[used.Length];
            byte[][] own = binned.Select(b => used.Select(i => b[i]).ToArray()).ToArray();
            double[][] values = Enumerable.Range(0, bins.FeatureCount).Select(f => new double[bins.EdgesOf(f).Length + 1]).ToArray();
            var splits = new Split[bins.FeatureCount];
            for (int round = 0; round < Rounds; round++)
            {
                for (int i = 0; i < used.Length; i++)
                {
                    double probability = 1 / (1 + Math.Exp(-logOdds[i])), weight = weights[used[i]];
                    gradient[i] = weight * ((isDot[used[i]] ? 1 : 0) - probability);
                    hessian[i] = weight * probability * (1 - probability) + 1e-9;
                }

                Parallel.For(0, splits.Length, f => splits[f] = BestSplit(own[f], gradient, hessian, values[f].Length));
                int best = 0;
                for (int f = 1; f < splits.Length; f++)
                    best = splits[f].Gain > splits[best].Gain ? f : best;
                if (!(splits[best].Gain > 0))
                    break;
                Split split = splits[best];
                for (int bin = 0; bin < values[best].Length; bin++)
                    values[best][bin] += bin > split.Bin ? split.Above : split.Below;
                for (int i = 0; i < used.Length; i++)
                    logOdds[i] += own[best][i] > split.Bin ? split.Above : split.Below;
            }

            return new BoostedCurves(baseLogOdds, Enumerable.Range(0, bins.FeatureCount).Select(bins.EdgesOf).ToArray(), values);
        }

        private Split BestSplit(byte[] bin, double[] gradient, double[] hessian, int count)
        {
            Span<double> sumGradient = stackalloc double[256], sumHessian = stackalloc double[256];
            sumGradient.Clear();
            sumHessian.Clear();
            for (int i = 0; i < bin.Length; i++)
            {
                sumGradient[bin[i]] += gradient[i];
                sumHessian[bin[i]] += hessian[i];
            }

            double totalGradient = 0, totalHessian = 0;
            for (int b = 0; b < count; b++)
            {
                totalGradient += sumGradient[b];
                totalHessian += sumHessian[b];
            }

            double Score(double g, double h) => g * g / (h + Penalty);
            var best = default(Split);
            double below = 0, hessianBelow = 0;
            for (int b = 0; b < count - 1; b++)
            {
                below += sumGradient[b];
                hessianBelow += sumHessian[b];
                double above = totalGradient - below, hessianAbove = totalHessian - hessianBelow;
                if (hessianBelow < LeastHessian || hessianAbove < LeastHessian)
                    continue;
                double gain = Score(below, hessianBelow) + Score(above, hessianAbove) - Score(totalGradient, totalHessian);
                if (gain > best.Gain)
                    best = new Split(gain, b, Rate * below / (hessianBelow + Penalty), Rate * above / (hessianAbove + Penalty));
            }

            return best;
        }

        /// <summary>One tree: bins up to this one gain the first value, those above the second.</summary>
        private readonly record struct Split(double Gain, int Bin, double Below, double Above);
    }
}
