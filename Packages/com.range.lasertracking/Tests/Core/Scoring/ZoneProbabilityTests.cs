using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class ZoneProbabilityTests
    {
        private const double Tolerance = 0.01;

        [TestCase(0.02)]
        [TestCase(0.05)]
        [TestCase(0.1)]
        [TestCase(0.3)]
        public void ZoneProbability_CentredCircle_IsTheRayleighDistribution(double sigma)
        {
            double expected = 1 - Math.Exp(-0.1 * 0.1 / (2 * sigma * sigma));
            double p = ZoneProbability.Of(TestScenes.Rings, 0, default, Covariance2D.Isotropic(sigma));
            Assert.That(p, Is.EqualTo(expected).Within(Tolerance));
        }

        [TestCase(-1.0, 0.158655)]
        [TestCase(0.0, 0.5)]
        [TestCase(0.5, 0.691462)]
        [TestCase(2.0, 0.977250)]
        public void ZoneProbability_StraightEdge_IsTheNormalDistribution(double sigmasInside, double expected)
        {
            // Only the right edge of the card, at x = 0.5, is within reach; the variance along x is 0.01².
            var covariance = new Covariance2D(1e-4, 0.7e-4, 1e-4);
            double p = ZoneProbability.Of(TestScenes.NoShoot, 0, new Vector2D(0.5 - 0.01 * sigmasInside, 0), covariance);
            Assert.That(p, Is.EqualTo(expected).Within(Tolerance));
        }

        [Test]
        public void ZoneProbability_AllZonesAndOutside_SumToOne()
        {
            Covariance2D covariance = Covariance2D.Isotropic(0.3);
            var mean = new Vector2D(0.1, 0.2);
            double sum = ZoneProbability.Of(TestScenes.Rings, -1, mean, covariance);
            for (int zone = 0; zone < TestScenes.Rings.Zones.Count; zone++)
                sum += ZoneProbability.Of(TestScenes.Rings, zone, mean, covariance);
            Assert.That(sum, Is.EqualTo(1).Within(1e-12));
        }

        [Test]
        public void ZoneProbability_RandomZonesAndCovariances_AgreeWithMonteCarlo()
        {
            var random = new Random(11);
            for (int i = 0; i < 40; i++)
            {
                double a = 0.02 + 0.2 * random.NextDouble(), b = 0.3 * (random.NextDouble() - 0.5), c = 0.02 + 0.2 * random.NextDouble();
                var mean = new Vector2D(random.NextDouble() - 0.5, random.NextDouble() - 0.5);
                int zone = random.Next(-1, 2), inside = 0;
                const int Draws = 40000;
                for (int k = 0; k < Draws; k++)
                {
                    double r = Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())), angle = 2 * Math.PI * random.NextDouble();
                    double u = r * Math.Cos(angle), v = r * Math.Sin(angle);
                    if (TestScenes.Rings.ZoneAt(new Vector2D(mean.X + a * u, mean.Y + b * u + c * v)) == zone)
                        inside++;
                }

                double p = ZoneProbability.Of(TestScenes.Rings, zone, mean, new Covariance2D(a * a, a * b, b * b + c * c));
                Assert.That(p, Is.EqualTo(inside / (double)Draws).Within(0.015), "case " + i);
            }
        }

        [Test]
        public void ZoneProbability_NoUncertainty_IsCertain()
        {
            Assert.That(ZoneProbability.Of(TestScenes.Rings, 0, default, default), Is.EqualTo(1));
            Assert.That(ZoneProbability.Of(TestScenes.Rings, 1, default, default), Is.EqualTo(0));
        }

        [Test]
        public void ZoneProbability_LineOrNaN_IsHandled()
        {
            // All variance along x: a normal distribution over the line through the centre; ring of 0.1 m at 1 sigma.
            Assert.That(ZoneProbability.Of(TestScenes.Rings, 0, default, new Covariance2D(0.01, 0, 0)), Is.EqualTo(0.682689).Within(Tolerance));
            Assert.That(ZoneProbability.Of(TestScenes.Rings, 0, default, new Covariance2D(0, 0, 0.01)), Is.EqualTo(0.682689).Within(Tolerance));
            Assert.That(ZoneProbability.Of(TestScenes.Rings, 0, default, new Covariance2D(double.NaN, 0, 1)), Is.EqualTo(0));
        }
    }
}
