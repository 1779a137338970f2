using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class Vector3DTests
    {
        [TestCase(0, 0, 1, 1, 0, 0, -90)]
        [TestCase(1, 0, 0, 0, 0, 1, 90)]
        [TestCase(1, 5, 1, 1, -2, 1, 0)]
        [TestCase(1, 0, 0, -1, 3, 0, 180)]
        public void Turn_BetweenBearings_IsTheirAngleWhateverTheSlopes(double ax, double ay, double az, double bx, double by, double bz, double degrees)
        {
            double turn = Vector3D.Turn(new Vector3D(ax, ay, az), new Vector3D(bx, by, bz));
            Assert.That(turn * 180 / Math.PI, Is.EqualTo(degrees).Within(1e-9));
        }
    }
}
