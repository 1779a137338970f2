using System;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class ZoneScoringRuleTests
    {
        [TestCase(5, 0.6, 5.0, 5.0)]
        [TestCase(5, 1.0, 5.0, 5.0)]
        [TestCase(5, 0.3, 5.0, 3.75)]
        [TestCase(5, 0.0, 2.0, 2.5)]
        [TestCase(5, 0.9, 15.0, 6.0)]
        [TestCase(5, 0.9, 30.0, 7.5)]
        [TestCase(5, 0.9, 90.0, 7.5)]
        [TestCase(10, 0.3, 10.0, 8.25)]
        public void ZoneScoringRule_Defaults_FollowTheFormula(int points, double confidence, double distanceM, double expected)
        {
            Assert.That(Score(new ZoneScoringRule(), points, confidence, distanceM), Is.EqualTo(expected).Within(1e-12));
        }

        [TestCase(0.0)]
        [TestCase(0.3)]
        [TestCase(1.0)]
        public void ZoneScoringRule_Penalty_CountsInFull(double confidence)
        {
            Assert.That(Score(new ZoneScoringRule(), -10, confidence, 25), Is.EqualTo(-10));
        }

        [Test]
        public void ZoneScoringRule_ConfidenceNaN_CountsAsNone()
        {
            Assert.That(Score(new ZoneScoringRule(), 10, double.NaN, 5), Is.EqualTo(5));
        }

        [Test]
        public void ZoneScoringRule_OtherSettings_AreUsed()
        {
            var rule = new ZoneScoringRule(1, 0, 0, 0, 1);
            Assert.That(Score(rule, 8, 0.25, 50), Is.EqualTo(2).Within(1e-12));
        }

        [Test]
        public void ZoneScoringRule_SenselessSettings_AreRefused()
        {
            Assert.That(() => new ZoneScoringRule(fullConfidence: 0), Throws.ArgumentException);
            Assert.That(() => new ZoneScoringRule(fullConfidence: double.NaN), Throws.ArgumentException);
            Assert.That(() => new ZoneScoringRule(leastCertainty: 1.1), Throws.ArgumentException);
            Assert.That(() => new ZoneScoringRule(nearDistanceM: -1), Throws.ArgumentException);
            Assert.That(() => new ZoneScoringRule(mostDifficulty: 0.9), Throws.ArgumentException);
        }

        private static double Score(ZoneScoringRule rule, int points, double confidence, double distanceM)
        {
            var hit = new ScoredHit { Points = points, DistanceM = distanceM };
            return rule.Score(hit, TestScenes.Rings, confidence);
        }
    }
}
