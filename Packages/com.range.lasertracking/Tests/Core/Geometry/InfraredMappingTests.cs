using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class InfraredMappingTests
    {
        // Of the size of a depth camera's real coefficients.
        private static readonly LensCamera Infrared = new LensCamera(new PinholeCamera(504.6, 504.8, 513.7, 513.3, 1024, 1024),
            new BrownDistortion(new[] { 0.5825, 0.0061, -0.0013, 0.9256, 0.1257, -0.0065 }, -1.3e-4, -2.1e-5));

        private static readonly LensCamera Color = new LensCamera(new PinholeCamera(923.7, 923.4, 952.3, 544.4, 1920, 1080),
            new BrownDistortion(new[] { -1.0576, -1.3993, 1.7509, -1.1485, -1.1924, 1.6221 }, 6.9e-4, -1.2e-5, 1.7));

        private static readonly Pose Rig = new Pose(new Vector3D(-32, -2.5, 3.6), Rotation3D.AboutAxis(new Vector3D(1, 0, 0), 0.1));

        [Test]
        public void OfCameras_PointsOfThePlane_MapToWhereTheColorCameraSeesThem()
        {
            InfraredMapping mapping = InfraredMapping.OfCameras(Infrared, Color, Rig, 2400);
            Check(mapping, (x, y) => new Vector3D(x, y, 2400));
        }

        [Test]
        public void OnScreen_ObliquePlane_IsRecoveredFromTheScreensCorners()
        {
            var pose = new Pose(new Vector3D(-900, -500, 2300), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), 0.3));
            var corners = new Vector2D[4];
            var screenM = new[] { new Vector2D(0, 0), new Vector2D(1.8, 0), new Vector2D(1.8, 1.0), new Vector2D(0, 1.0) };
            for (int i = 0; i < 4; i++)
                corners[i] = Project(pose.TransformPoint(new Vector3D(screenM[i].X * 1000, screenM[i].Y * 1000, 0)));
            Assert.That(HomographyEstimator.TryFit(corners, screenM, out Homography imageToScreen, out string reason), Is.True, reason);
            InfraredMapping mapping = InfraredMapping.OnScreen(Infrared, Color, Rig, new ScreenGeometry(imageToScreen, new Vector2D(1.8, 1.0)));
            Check(mapping, (x, y) => pose.TransformPoint(new Vector3D(x + 900, y + 500, 0)));
        }

        [Test]
        public void EqualFields_CornersOfOnePicture_AreCornersOfTheOther()
        {
            InfraredMapping mapping = InfraredMapping.EqualFields(1024, 1024, 1920, 1080);
            Assert.That(mapping.TryMap(new Vector2D(-0.5, -0.5), out Vector2D first), Is.True);
            Assert.That(mapping.TryMap(new Vector2D(1023.5, 1023.5), out Vector2D last), Is.True);
            Assert.That((first - new Vector2D(-0.5, -0.5)).Length + (last - new Vector2D(1919.5, 1079.5)).Length, Is.LessThan(1e-9));
        }

        [Test]
        public void IsFor_PicturesOfAnotherSize_IsFalse()
        {
            InfraredMapping mapping = InfraredMapping.OfCameras(Infrared, Color, Rig, 2400);
            Assert.That(mapping.IsFor(1024, 1024, 1920, 1080), Is.True);
            Assert.That(mapping.IsFor(640, 576, 1920, 1080), Is.False);
            Assert.That(mapping.IsFor(1024, 1024, 1280, 720), Is.False);
        }

        [TestCase(0)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void OfCameras_DistanceThatIsNone_IsRefused(double distanceMm) =>
            Assert.Throws<ArgumentException>(() => InfraredMapping.OfCameras(Infrared, Color, Rig, distanceMm));

        [Test]
        public void BrownDistortion_PointThatNoRayReaches_IsRefused()
        {
            var barrel = new BrownDistortion(new[] { -0.3, 0, 0 }, 0, 0);
            Assert.That(barrel.TryUndistort(new Vector2D(2, 0), out _), Is.False);
            Assert.Throws<ArgumentException>(() => new BrownDistortion(new[] { double.NaN, 0, 0 }, 0, 0));
            Assert.Throws<ArgumentException>(() => new BrownDistortion(new double[4], 0, 0));
        }

        private static void Check(InfraredMapping mapping, Func<double, double, Vector3D> inColorMm)
        {
            for (double x = -700; x <= 700; x += 175)
            {
                for (double y = -400; y <= 400; y += 100)
                {
                    Vector3D p = inColorMm(x, y), q = Rig.InverseTransformPoint(p);
                    Assert.That(Infrared.TryProject(new Vector2D(q.X / q.Z, q.Y / q.Z), out Vector2D infraredPx), Is.True);
                    Assert.That(mapping.TryMap(infraredPx, out Vector2D colorPx), Is.True);
                    Assert.That((colorPx - Project(p)).Length, Is.LessThan(1e-5));
                }
            }
        }

        private static Vector2D Project(Vector3D p)
        {
            Assert.That(Color.TryProject(new Vector2D(p.X / p.Z, p.Y / p.Z), out Vector2D pixel), Is.True);
            return pixel;
        }
    }
}
