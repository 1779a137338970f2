using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class ScreenPlaneTests
    {
        private static readonly Vector2D Size = new Vector2D(3.73, 2.26);
        private static readonly LensCamera Camera = new LensCamera(new PinholeCamera(905, 906, 962, 541, 1920, 1080), BrownDistortion.FromOpenCv(new[] { -0.12, 0.03, 0.001, -0.0007, 0 }));

        // The screen 3.5 m before the camera, turned and tilted.
        private static readonly Pose Truth = new Pose(new Vector3D(-1700, -1200, 3300), Rotation3D.FromVector(new Vector3D(0.12, -0.21, 0.03)));

        [Test]
        public void ScreenPlane_FromSizeAndCorners_IsWhereTheScreenStands()
        {
            Assert.That(ScreenPlane.TryFromSize(Screen(Size), Camera, out ScreenPlane? plane, out string reason), Is.True, reason);
            Assert.That((plane!.ScreenToCameraMm.Position - Truth.Position).Length, Is.LessThan(1e-5));
            Assert.That((Truth.Rotation.Inverse * plane.ScreenToCameraMm.Rotation).ToVector().Length, Is.LessThan(1e-9));
            Assert.That(plane.CornerRmsPx, Is.LessThan(1e-8));
        }

        [Test]
        public void ScreenPlane_RayOfAPixel_MeetsTheScreenWhereTheHomographySaysSo()
        {
            ScreenGeometry screen = Screen(Size);
            Assert.That(ScreenPlane.TryFromSize(screen, Camera, out ScreenPlane? plane, out _), Is.True);
            foreach (var pixel in new[] { new Vector2D(700, 420), new Vector2D(1200, 700), new Vector2D(960, 300) })
            {
                Assert.That(plane!.TryHit(pixel, out Vector3D cameraMm), Is.True);
                Vector3D hit = plane.ToScreenM(cameraMm);
                Assert.That((new Vector2D(hit.X, hit.Y) - screen.ToScreenM(pixel)).Length, Is.LessThan(1e-8));
                Assert.That(hit.Z, Is.EqualTo(0).Within(1e-9));
            }
        }

        [Test]
        public void ScreenPlane_WrongSize_ShowsInTheCornersAndAgainstTheDepthPlane()
        {
            ScreenGeometry right = Screen(Size), wrong = new ScreenGeometry(new Homography(new double[] { 1.05, 0, 0, 0, 1, 0, 0, 0, 1 }) * right.ImageToScreen, new Vector2D(Size.X * 1.05, Size.Y), Camera);
            Assert.That(ScreenPlane.TryFromSize(wrong, Camera, out ScreenPlane? plane, out _), Is.True);
            Assert.That(plane!.CornerRmsPx, Is.GreaterThan(1));
            var measured = new Plane3D(Truth.TransformDirection(new Vector3D(0, 0, 1)), Truth.Position);
            Assert.That(plane.TryCompare(measured, out ScreenPlaneAgreement agreement), Is.True);
            Assert.That(agreement.WorstCornerMm, Is.GreaterThan(40));
            Assert.That(agreement.OtherSizeM.X, Is.EqualTo(Size.X).Within(1e-6));

            Assert.That(ScreenPlane.TryFromSize(right, Camera, out plane, out _), Is.True);
            Assert.That(plane!.TryCompare(measured, out agreement), Is.True);
            Assert.That(new[] { agreement.AngleRad, agreement.MiddleMm, agreement.WorstCornerMm }, Is.All.LessThan(1e-4));
            Assert.That((agreement.OtherSizeM - Size).Length, Is.LessThan(1e-6));
        }

        [Test]
        public void PlaneFit_WithAThirdOfThePointsOnSomethingElse_FindsTheWall()
        {
            var random = new Random(7);
            var points = new Vector3D[3000];
            var truth = new Plane3D(new Vector3D(0.1, -0.05, 1), new Vector3D(0, 0, 3000));
            for (int i = 0; i < points.Length; i++)
            {
                double x = 3000 * (random.NextDouble() - 0.5), y = 2000 * (random.NextDouble() - 0.5);
                double z = (truth.Distance - truth.Normal.X * x - truth.Normal.Y * y) / truth.Normal.Z;
                double noise = 0;
                for (int k = 0; k < 12; k++)
                    noise += random.NextDouble() - 0.5;
                points[i] = i % 3 == 0 ? new Vector3D(0.3 * x, y, 1800 + 300 * random.NextDouble()) : new Vector3D(x, y, z + 5 * noise);
            }

            Assert.That(PlaneFit.TryFit(points, out PlaneFit? fit, out string reason), Is.True, reason);
            Assert.That(Vector3D.Cross(fit!.Plane.Normal, truth.Normal).Length, Is.LessThan(1e-3));
            Assert.That(fit.Plane.Distance, Is.EqualTo(truth.Distance).Within(0.6));
            Assert.That(fit.Sigma, Is.EqualTo(5 * truth.Normal.Z).Within(0.5));
            Assert.That(fit.NearCount, Is.InRange(1950, 2010));
        }

        [Test]
        public void PlaneFit_PointsThatFixNoPlane_AreRefusedWithAReason()
        {
            Assert.That(PlaneFit.TryFit(new Vector3D[2], out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain("three"));
            var line = new Vector3D[50];
            for (int i = 0; i < line.Length; i++)
                line[i] = new Vector3D(i, 2 * i, 100 + 3 * i);
            Assert.That(PlaneFit.TryFit(line, out _, out reason), Is.False);
            Assert.That(reason, Does.Contain("line"));
            line[7] = new Vector3D(double.NaN, 0, 0);
            Assert.That(PlaneFit.TryFit(line, out _, out reason), Is.False);
            Assert.That(reason, Does.Contain("finite"));
        }

        [Test]
        public void Plane3D_RayAwayFromIt_DoesNotMeet()
        {
            var plane = new Plane3D(new Vector3D(0, 0, 2), new Vector3D(0, 0, 1000));
            Assert.That(plane.TryIntersect(new Ray3D(default, new Vector3D(0.1, 0, 1)), out Vector3D point), Is.True);
            Assert.That((point - new Vector3D(100, 0, 1000)).Length, Is.LessThan(1e-9));
            Assert.That(plane.TryIntersect(new Ray3D(default, new Vector3D(0, 0, -1)), out _), Is.False);
            Assert.That(plane.TryIntersect(new Ray3D(default, new Vector3D(1, 0, 0)), out _), Is.False);
        }

        private static ScreenGeometry Screen(Vector2D size)
        {
            Vector2D[] cornersM = ScreenGeometry.CornersOf(size), image = new Vector2D[4];
            for (int i = 0; i < 4; i++)
                Assert.That(Camera.TryProject(Truth.TransformPoint(new Vector3D(cornersM[i].X * 1000, cornersM[i].Y * 1000, 0)), out image[i]), Is.True);
            Assert.That(ScreenGeometry.TryFit(image, cornersM, size, Camera, 0.1, out ScreenGeometry? screen, out string reason), Is.True, reason);
            return screen!;
        }
    }
}
