using System;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class DotEvidenceTests
    {
        [Test]
        public void DotEvidence_HasOneCurveForEachFeature()
        {
            Assert.That(DotEvidence.Count, Is.EqualTo(Enum.GetValues(typeof(DotFeature)).Length));
            Assert.That(DotEvidence.Learned.Curves.ToArray().Select(c => c.What), Is.Unique.And.All.Not.Empty);
            Assert.That(DotEvidence.Learned.Curves.ToArray().Select(c => c.Reason), Has.None.EqualTo(RejectionReason.None));
        }

        [Test]
        public void DotEvidence_LogOdds_IsTheSumOfWhatEachFeatureSays()
        {
            var features = new float[DotEvidence.Count];
            double expected = DotEvidence.Learned.Base;
            for (int i = 0; i < features.Length; i++)
            {
                features[i] = 0.3f * i;
                expected += DotEvidence.Learned.Curves[i].At(features[i]);
            }

            Assert.That(DotEvidence.Learned.LogOdds(features), Is.EqualTo(expected).Within(1e-9));
        }

        [Test]
        public void DotEvidence_AStrongRoundLonelyDot_OutweighsAStreakAmongMotion()
        {
            float[] dot = Typical(), streak = Typical();
            streak[(int)DotFeature.LogElongation] = 2.5f;
            streak[(int)DotFeature.RisenAround] = 0.2f;
            streak[(int)DotFeature.ActivityAround] = 1;
            Assert.That(DotEvidence.Learned.LogOdds(dot), Is.GreaterThan(DotEvidence.Learned.LogOdds(streak) + 4));
        }

        [Test]
        public void DotEvidence_StrongestAgainst_IsTheFeatureThatLosesMost()
        {
            float[] streak = Typical();
            streak[(int)DotFeature.LogElongation] = 3;
            streak[(int)DotFeature.ContentExcess] = 1;
            Assert.That(DotEvidence.Learned.StrongestAgainst(streak, true), Is.EqualTo((int)DotFeature.LogElongation));
        }

        /// <summary>Whatever the curves are: where each says most for a dot.</summary>
        private static float[] Typical()
        {
            var features = new float[DotEvidence.Count];
            for (int i = 0; i < features.Length; i++)
            {
                EvidenceCurve curve = DotEvidence.Learned.Curves[i];
                features[i] = Enumerable.Range(-800, 1600).Select(n => n / 100f).OrderByDescending(v => curve.At(v)).First();
            }

            return features;
        }
    }
}
