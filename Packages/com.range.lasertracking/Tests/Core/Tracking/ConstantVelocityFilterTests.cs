using System;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    public sealed class ConstantVelocityFilterTests
    {
        [Test]
        public void PredictAndUpdate_RandomMeasurements_EqualTheMatrixForm()
        {
            var random = new Random(8);
            for (int trial = 0; trial < 50; trial++)
            {
                var filter = new ConstantVelocityFilter(5, 2, 300);
                double[] x = { 5, 0 };
                double[,] p = { { 2, 0 }, { 0, 300 } };
                for (int i = 0; i < 30; i++)
                {
                    double step = 0.1 + random.NextDouble(), q00 = random.NextDouble(), q01 = 0.1 * q00, q11 = random.NextDouble();
                    filter.Predict(step, q00, q01, q11);
                    double[,] f = { { 1, step }, { 0, 1 } };
                    x = new[] { x[0] + step * x[1], x[1] };
                    p = Multiply(Multiply(f, p), new[,] { { 1, 0 }, { step, 1 } });
                    p = new[,] { { p[0, 0] + q00, p[0, 1] + q01 }, { p[1, 0] + q01, p[1, 1] + q11 } };
                    if (random.Next(3) > 0)
                    {
                        double z = 10 * random.NextDouble(), r = 0.5 + random.NextDouble();
                        filter.Update(z, r);
                        double s = p[0, 0] + r, k0 = p[0, 0] / s, k1 = p[1, 0] / s, y = z - x[0];
                        x = new[] { x[0] + k0 * y, x[1] + k1 * y };

                        // Joseph's form, right for any gain.
                        double[,] a = { { 1 - k0, 0 }, { -k1, 1 } };
                        p = Multiply(Multiply(a, p), new[,] { { 1 - k0, -k1 }, { 0, 1 } });
                        p = new[,] { { p[0, 0] + k0 * k0 * r, p[0, 1] + k0 * k1 * r }, { p[1, 0] + k0 * k1 * r, p[1, 1] + k1 * k1 * r } };
                    }

                    Assert.That(filter.Position, Is.EqualTo(x[0]).Within(1e-8));
                    Assert.That(filter.Velocity, Is.EqualTo(x[1]).Within(1e-8));
                    Assert.That(filter.PositionVariance, Is.EqualTo(p[0, 0]).Within(1e-8));
                    Assert.That(filter.Covariance, Is.EqualTo(p[0, 1]).Within(1e-8));
                    Assert.That(filter.VelocityVariance, Is.EqualTo(p[1, 1]).Within(1e-8));
                }
            }
        }

        private static double[,] Multiply(double[,] a, double[,] b)
        {
            var c = new double[2, 2];
            for (int i = 0; i < 2; i++)
            {
                for (int j = 0; j < 2; j++)
                    c[i, j] = a[i, 0] * b[0, j] + a[i, 1] * b[1, j];
            }

            return c;
        }
    }
}
