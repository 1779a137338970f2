using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class EvidenceCurveTests
    {
        private static readonly EvidenceCurve Curve = new EvidenceCurve("size", RejectionReason.TooLarge, new[] { 1f, 2f, 4f }, new[] { -2f, 0.5f, 1.5f, -1f });

        [TestCase(float.NegativeInfinity, -2f)]
        [TestCase(0.999f, -2f)]
        [TestCase(1f, 0.5f)]
        [TestCase(1.999f, 0.5f)]
        [TestCase(2f, 1.5f)]
        [TestCase(4f, -1f)]
        [TestCase(float.PositiveInfinity, -1f)]
        [TestCase(float.NaN, -2f)]
        public void EvidenceCurve_At_ChangesOnItsEdges(float value, float expected) => Assert.That(Curve.At(value), Is.EqualTo(expected));

        [TestCase(0f, 1f, Description = "too small: up to the first edge")]
        [TestCase(-100f, 1f)]
        [TestCase(9f, 4f, Description = "too large: down to the last edge")]
        [TestCase(4f, 4f, Description = "at the last edge: below it")]
        [TestCase(1f, 2f, Description = "speaks for a dot: where it says more")]
        [TestCase(3.5f, 3.5f, Description = "says the most: itself")]
        public void EvidenceCurve_NearestLimit_IsWhereItWouldSpeakForADot(float value, float expected)
        {
            float limit = Curve.NearestLimit(value);
            Assert.That(limit, Is.EqualTo(expected).Within(1e-5));
            Assert.That(Curve.At(limit), expected == value && value < 4 ? Is.EqualTo(Curve.At(value)) : Is.GreaterThan(Curve.At(value)));
        }

        [Test]
        public void EvidenceCurve_NearestLimit_OfACurveThatIsNeverFor_IsWhereItSaysLessAgainst()
        {
            var against = new EvidenceCurve("size", RejectionReason.TooLarge, new[] { 1f }, new[] { -2f, -1f });
            Assert.That(against.NearestLimit(-3), Is.EqualTo(1));
            Assert.That(against.NearestLimit(5), Is.EqualTo(5));
        }

        [Test]
        public void EvidenceCurve_NearestLimit_BetweenTwo_IsTheNearerOne()
        {
            var valley = new EvidenceCurve("size", RejectionReason.TooLarge, new[] { 0f, 10f }, new[] { 1f, -1f, 1f });
            Assert.That(valley.NearestLimit(3), Is.EqualTo(0).Within(1e-5));
            Assert.That(valley.NearestLimit(8), Is.EqualTo(10));
        }

        [Test]
        public void EvidenceCurve_Highest_IsItsLargestValue() => Assert.That(Curve.Highest, Is.EqualTo(1.5f));

        [Test]
        public void EvidenceCurve_ValuesThatDoNotFit_AreRefused() =>
            Assert.Throws<ArgumentException>(() => new EvidenceCurve("size", RejectionReason.TooLarge, new[] { 1f }, new[] { 1f }));
    }
}
