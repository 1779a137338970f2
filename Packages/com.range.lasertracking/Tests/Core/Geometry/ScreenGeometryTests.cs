using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class ScreenGeometryTests
    {
        private static readonly Vector2D Size = new Vector2D(3.73, 2.26);
        private static readonly LensCamera Barrel = Camera(-0.28, 0.03);

        [Test]
        public void ScreenGeometry_WithALens_MapsThereAndBackAndLinearises()
        {
            ScreenGeometry screen = Truth(Barrel);
            foreach (Vector2D screenM in new[] { new Vector2D(0.05, 0.04), new Vector2D(1.8, 1.1), new Vector2D(3.7, 2.2) })
            {
                Vector2D pixel = screen.ToImagePx(screenM);
                Assert.That((screen.ToScreenM(pixel) - screenM).Length, Is.LessThan(1e-9));
                screen.Jacobian(pixel, out double xx, out double xy, out double yx, out double yy);
                const double step = 1e-3;
                Vector2D byX = (screen.ToScreenM(pixel + new Vector2D(step, 0)) - screen.ToScreenM(pixel - new Vector2D(step, 0))) * (0.5 / step);
                Vector2D byY = (screen.ToScreenM(pixel + new Vector2D(0, step)) - screen.ToScreenM(pixel - new Vector2D(0, step))) * (0.5 / step);
                Assert.That(new[] { xx, xy, yx, yy }, Is.EqualTo(new[] { byX.X, byY.X, byX.Y, byY.Y }).Within(1e-8));
                Covariance2D mm2 = screen.ToScreenMm2(pixel, new Covariance2D(0.01, 0.002, 0.03));
                Covariance2D expected = new Covariance2D(0.01, 0.002, 0.03).Transform(1000 * byX.X, 1000 * byY.X, 1000 * byX.Y, 1000 * byY.Y);
                Assert.That(new[] { mm2.XX, mm2.XY, mm2.YY }, Is.EqualTo(new[] { expected.XX, expected.XY, expected.YY }).Within(1e-5));
            }
        }

        [Test]
        public void ScreenGeometry_WhenTheLensIsIgnored_IsOffByManyMillimetres()
        {
            ScreenGeometry truth = Truth(Barrel);
            Grid(truth, 0, 1, out Vector2D[] image, out Vector2D[] screenM);
            Assert.That(ScreenGeometry.TryFit(image, screenM, Size, Barrel, 0.1, out ScreenGeometry? corrected, out string reason), Is.True, reason);
            Assert.That(ScreenGeometry.TryFit(image, screenM, Size, null, 0.1, out ScreenGeometry? raw, out _), Is.True);
            double worst = 0, worstRaw = 0;
            for (int i = 0; i < image.Length; i++)
            {
                worst = Math.Max(worst, (corrected!.ToScreenM(image[i]) - screenM[i]).Length * 1000);
                worstRaw = Math.Max(worstRaw, (raw!.ToScreenM(image[i]) - screenM[i]).Length * 1000);
            }

            Assert.That(worst, Is.LessThan(1e-6));
            Assert.That(worstRaw, Is.GreaterThan(10));
        }

        [Test]
        public void ScreenGeometry_CalibrationFromNoisyPoints_SaysHowFarItIsOff([Values(4, 54)] int points)
        {
            ScreenGeometry truth = Truth(Barrel);
            Vector2D pixel = truth.ToImagePx(new Vector2D(3.2, 0.4));
            Vector2D place = truth.ToScreenM(pixel);
            double sumXX = 0, sumYY = 0, saidXX = 0, saidYY = 0;
            const int trials = 400;
            for (int trial = 0; trial < trials; trial++)
            {
                Grid(truth, 0.3, trial + 1, out Vector2D[] image, out Vector2D[] screenM, points);
                Assert.That(ScreenGeometry.TryFit(image, screenM, Size, Barrel, 0.3, out ScreenGeometry? fitted, out string reason), Is.True, reason);
                Vector2D off = (fitted!.ToScreenM(pixel) - place) * 1000;
                Covariance2D said = fitted.ToScreenMm2(pixel, default);
                sumXX += off.X * off.X / trials;
                sumYY += off.Y * off.Y / trials;
                saidXX += said.XX / trials;
                saidYY += said.YY / trials;
            }

            // 400 draws know a variance to 7 %; three times that.
            Assert.That(saidXX / sumXX, Is.EqualTo(1).Within(0.22));
            Assert.That(saidYY / sumYY, Is.EqualTo(1).Within(0.22));
        }

        [Test]
        public void ScreenGeometry_Outline_HoldsTheWholeScreen()
        {
            ScreenGeometry screen = Truth(Barrel);
            Vector2D[] outline = screen.OutlinePx, corners = screen.CornersPx;
            int outsideCorners = 0;
            for (int i = 0; i <= 40; i++)
            {
                Vector2D edge = screen.ToImagePx(new Vector2D(Size.X * i / 40, 0));
                Assert.That(Polygon2D.Contains(outline, edge) || Polygon2D.DistanceToEdge(outline, edge) < 0.5, Is.True);
                outsideCorners += Polygon2D.Contains(corners, edge) ? 0 : 1;
            }

            Assert.That(outsideCorners, Is.GreaterThan(30));
        }

        [Test]
        public void ScreenGeometry_PointsOfNoUse_AreRefusedWithAReason()
        {
            ScreenGeometry truth = Truth(Barrel);
            Grid(truth, 0, 1, out Vector2D[] image, out Vector2D[] screenM);
            Refused(image[..3], screenM[..3], "four");
            Refused(image[..8], screenM[..8], "line");
            Refused(image[..10], screenM[..9], "partner");
            image[5] = new Vector2D(double.NaN, 0);
            Refused(image, screenM, "point 6 is not finite");
            image[5] = new Vector2D(90000, 0);
            Refused(image, screenM, "point 6");
        }

        [Test]
        public void ScreenGeometry_Mapping_AllocatesNothing()
        {
            ScreenGeometry truth = Truth(Barrel);
            Grid(truth, 0.2, 1, out Vector2D[] image, out Vector2D[] screenM);
            Assert.That(ScreenGeometry.TryFit(image, screenM, Size, Barrel, 0.3, out ScreenGeometry? screen, out _), Is.True);
            Assert.That(Allocation.Of(() =>
            {
                screen!.ToScreenM(image[3]);
                screen.ToScreenMm2(image[3], new Covariance2D(0.1, 0, 0.1));
            }), Is.Zero);
        }

        private static void Refused(Vector2D[] image, Vector2D[] screenM, string why)
        {
            Assert.That(ScreenGeometry.TryFit(image, screenM, Size, Barrel, 0.3, out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain(why));
        }

        private static LensCamera Camera(double k1, double k2) =>
            new LensCamera(new PinholeCamera(905, 906, 640, 360, 1280, 720), BrownDistortion.FromOpenCv(new[] { k1, k2, 0.001, -0.0007, 0 }));

        private static ScreenGeometry Truth(LensCamera camera) =>
            new ScreenGeometry(new Homography(new[] { 0.0034, 0.0001, -0.45, 0.0002, 0.0035, -0.3, 1e-5, 2e-5, 1 }), Size, camera);

        /// <summary>The points in rows of nine; with four: the corners of a slightly smaller picture.</summary>
        private static void Grid(ScreenGeometry truth, double noisePx, int seed, out Vector2D[] image, out Vector2D[] screenM, int points = 54)
        {
            var random = new Random(seed);
            image = new Vector2D[points];
            screenM = new Vector2D[points];
            int columns = points == 4 ? 2 : 9, rows = points / columns;
            for (int i = 0; i < points; i++)
            {
                screenM[i] = new Vector2D(Size.X * (0.05 + 0.9 * (i % columns) / (columns - 1)), Size.Y * (0.05 + 0.9 * (i / columns) / (rows - 1)));
                image[i] = truth.ToImagePx(screenM[i]) + new Vector2D(Gaussian(random), Gaussian(random)) * noisePx;
            }
        }

        private static double Gaussian(Random random) => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
    }
}
