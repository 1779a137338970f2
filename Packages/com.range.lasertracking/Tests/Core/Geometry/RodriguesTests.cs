using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class RodriguesTests
    {
        [Test]
        public void Rodrigues_Derivatives_AreThoseOfTheMatrix([Values(0, 1e-9, 1e-3, 0.0499, 0.0501, 0.7, 3.1, 5)] double angle)
        {
            Vector3D vector = new Vector3D(0.3, -0.8, 0.5).Normalized * angle;
            double[] matrix = new double[9], by = new double[27], above = new double[9], below = new double[9];
            Rodrigues.ToMatrix(vector, matrix, by);
            for (int k = 0; k < 3; k++)
            {
                const double step = 1e-5;
                Vector3D move = new Vector3D(k == 0 ? step : 0, k == 1 ? step : 0, k == 2 ? step : 0);
                Rodrigues.ToMatrix(vector + move, above);
                Rodrigues.ToMatrix(vector - move, below);
                for (int i = 0; i < 9; i++)
                    Assert.That(by[i * 3 + k], Is.EqualTo((above[i] - below[i]) / (2 * step)).Within(1e-9), "element " + i + " by component " + k);
            }
        }

        [Test]
        public void Rotation3D_Vector_ComesBackFromEveryAngle([Values(0, 1e-12, 1e-6, 0.3, 2.5, 3.14159)] double angle)
        {
            Vector3D vector = new Vector3D(-0.2, 0.9, 0.4).Normalized * angle;
            Rotation3D rotation = Rotation3D.FromVector(vector);
            Assert.That((rotation.ToVector() - vector).Length, Is.LessThan(1e-14));
            var matrix = new double[9];
            Rodrigues.ToMatrix(vector, matrix);
            Assert.That(rotation.ToMatrix(), Is.EqualTo(matrix).Within(1e-14));
            Assert.That(Rotation3D.TryFromMatrix(matrix, out Rotation3D again), Is.True);
            Assert.That((again.ToVector() - vector).Length, Is.LessThan(1e-13));
        }
    }
}
