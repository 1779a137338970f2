using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class ConfidenceModelTests
    {
        [Test]
        public void Of_AnyCandidate_KeepsEveryFactorInItsPublishedRange()
        {
            var random = new Random(7);
            for (int i = 0; i < 500; i++)
            {
                var candidate = new Candidate
                {
                    PeakRelativeRise = random.Next(256),
                    LogOdds = 20 * random.NextDouble() - 10,
                    GreenCoherence = 2 * random.NextDouble() - 1,
                    RingLevel = random.NextDouble(),
                    MotionShare = random.NextDouble(),
                    IsConclusive = random.Next(2) == 0,
                };
                ConfidenceFactors factors = ConfidenceModel.Of(candidate, random.NextDouble());
                AssertRanges(factors);
                AssertRanges(ConfidenceModel.Raise(factors, 3));
            }
        }

        [Test]
        public void Of_RoundVividAloneAndStill_IsNearlySure()
        {
            Assert.That(ConfidenceModel.Of(Dot(), 0.3).Sum, Is.GreaterThan(0.98));
        }

        [Test]
        public void Of_EachWorseMeasurement_LowersTheSum()
        {
            double best = ConfidenceModel.Of(Weak(), 0.3).Sum;
            Candidate lower = Weak(), restless = Weak(), crowded = Weak();
            lower.PeakRelativeRise -= 40;
            restless.MotionShare += 0.1;
            crowded.RingLevel += 0.1;
            Assert.That(ConfidenceModel.Of(lower, 0.3).Sum, Is.LessThan(best));
            Assert.That(ConfidenceModel.Of(restless, 0.3).Sum, Is.LessThan(best));
            Assert.That(ConfidenceModel.Of(crowded, 0.3).Sum, Is.LessThan(best));
            Assert.That(ConfidenceModel.Of(Weak(), 0.9).Sum, Is.LessThan(best));
        }

        [TestCase(1)]
        [TestCase(3)]
        public void Raise_ByLogOdds_IsBayesRule(double logOdds)
        {
            ConfidenceFactors before = ConfidenceModel.Of(Weak(), 0.5), after = ConfidenceModel.Raise(before, logOdds);
            double odds = before.Sum / (1 - before.Sum) * Math.Exp(logOdds);
            Assert.That(after.Sum, Is.EqualTo(odds / (1 + odds)).Within(1e-6));
        }

        private static void AssertRanges(in ConfidenceFactors f)
        {
            Assert.That(f.Peak, Is.InRange(0, 0.4));
            Assert.That(f.Contrast, Is.InRange(0, 0.3));
            Assert.That(f.Center, Is.InRange(0, 0.2));
            Assert.That(f.Stability, Is.InRange(0, 0.1));
            Assert.That(f.Sum, Is.InRange(0, 1));
        }

        private static Candidate Dot() => new Candidate
        {
            PeakRelativeRise = 250, Vividness = 2, GreenCoherence = 0.9, Compactness = 0.95, LongSigma = 2.1, ShortSigma = 2, IsConclusive = true,
        };

        private static Candidate Weak()
        {
            Candidate candidate = Dot();
            candidate.IsConclusive = false;
            candidate.PeakRelativeRise = 120;
            candidate.GreenCoherence = 0.3;
            return candidate;
        }
    }
}
