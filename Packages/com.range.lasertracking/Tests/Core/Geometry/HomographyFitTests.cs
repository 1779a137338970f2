using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class HomographyFitTests
    {
        private static readonly Homography Truth = new Homography(new[] { 310.0, 12, 140, -8, 295, 90, 0.01, 0.02, 1 });

        [Test]
        public void HomographyFit_Residuals_GiveTheNoiseThatWasPutIn()
        {
            Points(200, 0.4, 11, out Vector2D[] from, out Vector2D[] to);
            Assert.That(HomographyFit.TryFit(from, to, 5, out HomographyFit? fit, out string reason), Is.True, reason);
            Assert.That(fit!.Sigma, Is.InRange(0.36, 0.85));
            Assert.That(HomographyFit.TryFit(from, to, 0.4, out fit, out _), Is.True);
            Assert.That(fit!.Sigma, Is.EqualTo(0.4).Within(0.04));
            Assert.That(fit.Rms, Is.EqualTo(0.4 * Math.Sqrt(2)).Within(0.06));
        }

        [Test]
        public void HomographyFit_FourPoints_AreAsUncertainAsExpectedAtThemselves()
        {
            var from = new[] { new Vector2D(0, 0), new Vector2D(3.7, 0), new Vector2D(3.7, 2.2), new Vector2D(0, 2.2) };
            Vector2D[] to = Array.ConvertAll(from, Truth.Map);
            Assert.That(HomographyFit.TryFit(from, to, 0.5, out HomographyFit? fit, out string reason), Is.True, reason);
            double[,] covariance = fit!.Uncertainty.Of(from);
            for (int i = 0; i < 8; i++)
            for (int k = 0; k < 8; k++)
                Assert.That(covariance[i, k], Is.EqualTo(i == k ? 0.25 : 0).Within(1e-9));
            Covariance2D outside = fit.Uncertainty.At(new Vector2D(8, 2)), inside = fit.Uncertainty.At(new Vector2D(1.8, 1.1));
            Assert.That(outside.Sigma, Is.GreaterThan(1));
            Assert.That(inside.Sigma, Is.LessThan(0.5));
        }

        [Test]
        public void HomographyUncertainty_FromItsCorners_IsTheSameEverywhere()
        {
            Points(30, 0.4, 3, out Vector2D[] from, out Vector2D[] to);
            Assert.That(HomographyFit.TryFit(from, to, 0.4, out HomographyFit? fit, out string reason), Is.True, reason);
            var corners = new[] { new Vector2D(0, 0), new Vector2D(3.7, 0), new Vector2D(3.7, 2.2), new Vector2D(0, 2.2) };
            Assert.That(HomographyUncertainty.TryFromAnchors(fit!.Homography, corners, fit.Uncertainty.Of(corners), out HomographyUncertainty? again, out reason), Is.True, reason);
            foreach (var place in new[] { new Vector2D(0.2, 0.3), new Vector2D(2, 1), new Vector2D(3.6, 2.1) })
            {
                Covariance2D expected = fit.Uncertainty.At(place), found = again!.At(place);
                Assert.That(new[] { found.XX, found.XY, found.YY }, Is.EqualTo(new[] { expected.XX, expected.XY, expected.YY }).Within(1e-6 * expected.XX));
            }
        }

        [Test]
        public void HomographyUncertainty_WhatIsNoCovariance_IsRefused()
        {
            var corners = new[] { new Vector2D(0, 0), new Vector2D(3.7, 0), new Vector2D(3.7, 2.2), new Vector2D(0, 2.2) };
            var covariance = new double[8, 8];
            for (int i = 0; i < 8; i++)
                covariance[i, i] = 1;
            Assert.That(HomographyUncertainty.TryFromAnchors(Truth, corners, covariance, out _, out _), Is.True);
            covariance[2, 3] = 0.5;
            Refused("symmetric");
            covariance[3, 2] = 0.5;
            covariance[4, 4] = -1;
            Refused("negative");
            covariance[4, 4] = double.NaN;
            Refused("finite");
            covariance = new double[6, 6];
            Refused("8×8");

            void Refused(string why)
            {
                Assert.That(HomographyUncertainty.TryFromAnchors(Truth, corners, covariance, out _, out string reason), Is.False);
                Assert.That(reason, Does.Contain(why));
            }
        }

        private static void Points(int count, double noise, int seed, out Vector2D[] from, out Vector2D[] to)
        {
            var random = new Random(seed);
            from = new Vector2D[count];
            to = new Vector2D[count];
            for (int i = 0; i < count; i++)
            {
                from[i] = new Vector2D(3.7 * random.NextDouble(), 2.2 * random.NextDouble());
                double radius = noise * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())), angle = 2 * Math.PI * random.NextDouble();
                to[i] = Truth.Map(from[i]) + new Vector2D(Math.Cos(angle), Math.Sin(angle)) * radius;
            }
        }
    }
}
