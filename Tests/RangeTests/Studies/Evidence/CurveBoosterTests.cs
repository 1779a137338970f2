using System;
using System.Linq;
using LaserTracking.Host.Studies.Evidence;
using NUnit.Framework;

namespace LaserTracking.Studies.Evidence
{
    public sealed class CurveBoosterTests
    {
        private const int Samples = 20000;

        [Test]
        public void CurveBooster_KnownSteps_AreFoundWithTheirLogOdds()
        {
            // Truth: −1, +2 above 0.3 of the first feature, −1.5 above 0.7 of the second; the third says nothing.
            (float[][] features, bool[] isDot) = Draw(f => -1 + (f[0] >= 0.3f ? 2 : 0) + (f[1] >= 0.7f ? -1.5 : 0));
            BoostedCurves curves = Fit(features, isDot, Enumerable.Repeat(1.0, Samples).ToArray());
            Assert.That(Step(curves, 0, 0.25f, 0.35f), Is.EqualTo(2).Within(0.25));
            Assert.That(Step(curves, 0, 0.05f, 0.25f), Is.Zero.Within(0.25));
            Assert.That(Step(curves, 1, 0.6f, 0.8f), Is.EqualTo(-1.5).Within(0.25));
            Assert.That(curves.Values[2].Max() - curves.Values[2].Min(), Is.LessThan(0.25));
            Assert.That(curves.LogOdds(new[] { 0.9f, 0.1f, 0.5f }), Is.EqualTo(1).Within(0.25));
        }

        [Test]
        public void CurveBooster_SamplesOfNoWeight_ChangeNothing()
        {
            (float[][] features, bool[] isDot) = Draw(f => f[0] >= 0.5f ? 1 : -1);
            double[] weights = Enumerable.Range(0, Samples).Select(i => i % 3 == 0 ? 0.0 : 1).ToArray();
            BoostedCurves expected = Fit(features, isDot, weights);
            for (int i = 0; i < Samples; i += 3)
                isDot[i] = !isDot[i];
            BoostedCurves curves = Fit(features, isDot, weights);
            Assert.That(curves.Base, Is.EqualTo(expected.Base));
            Assert.That(curves.Values, Is.EqualTo(expected.Values));
        }

        [Test]
        public void CurveBooster_NothingToTellApart_IsRefused()
        {
            (float[][] features, bool[] _) = Draw(_ => 0);
            Assert.Throws<ArgumentException>(() => Fit(features, new bool[Samples], Enumerable.Repeat(1.0, Samples).ToArray()));
        }

        [Test]
        public void FeatureBins_OfAFewValues_HaveFewEdges()
        {
            float[][] samples = Enumerable.Range(0, 1000).Select(i => new[] { i % 2, 1.23456f, i }).ToArray();
            FeatureBins bins = FeatureBins.Of(samples, 24);
            Assert.That(bins.EdgesOf(0).Length, Is.LessThanOrEqualTo(3), "0, 1, and the quantile between them");
            Assert.That(bins.EdgesOf(1), Is.EqualTo(new[] { 1.235f }), "rounded as it is written");
            Assert.That(bins.EdgesOf(2).Length, Is.EqualTo(23));
            Assert.That(bins.EdgesOf(2), Is.Ordered);
            Assert.That(bins.Digitize(samples, 2)[0], Is.Zero);
            Assert.That(bins.Digitize(samples, 2)[999], Is.EqualTo(23));
        }

        private static (float[][] Features, bool[] IsDot) Draw(Func<float[], double> logOdds)
        {
            var random = new Random(5);
            float[][] features = Enumerable.Range(0, Samples).Select(_ => new[] { random.NextSingle(), random.NextSingle(), random.NextSingle() }).ToArray();
            return (features, features.Select(f => random.NextDouble() < 1 / (1 + Math.Exp(-logOdds(f)))).ToArray());
        }

        private static BoostedCurves Fit(float[][] features, bool[] isDot, double[] weights)
        {
            FeatureBins bins = FeatureBins.Of(features, 20);
            return new CurveBooster().Fit(bins, Enumerable.Range(0, 3).Select(f => bins.Digitize(features, f)).ToArray(), isDot, weights);
        }

        /// <summary>By how much a feature's curve rises from one value to another.</summary>
        private static double Step(BoostedCurves curves, int feature, float from, float to)
        {
            float[] low = { 0.5f, 0.5f, 0.5f }, high = { 0.5f, 0.5f, 0.5f };
            low[feature] = from;
            high[feature] = to;
            return curves.LogOdds(high) - curves.LogOdds(low);
        }
    }
}
