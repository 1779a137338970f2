using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class LensCameraTests
    {
        // Of a real depth camera's colour lens.
        private static readonly double[] Strong = { 0.45, -2.6, 0.0005, -0.0002, 1.55, 0.33, -2.42, 1.48 };
        private static readonly double[] Plain = { -0.28, 0.09, 0.001, -0.0007, -0.012 };

        [Test]
        public void LensCamera_Derivatives_AreThoseOfTheProjection([Values(5, 8)] int coefficients)
        {
            double[] lens = coefficients == 5 ? Plain : Strong;
            double[] values = { 0.31, -0.22, 1.4, 905, 910, 953, 541 };
            double[] byPoint = new double[6], byPinhole = new double[8], byDistortion = new double[2 * coefficients];
            Assert.That(Camera(values, lens).TryProject(Point(values), out Vector2D pixel, byPoint, byPinhole, byDistortion), Is.True);
            Assert.That(Camera(values, lens).TryProject(Point(values), out Vector2D same), Is.True);
            Assert.That((pixel - same).Length, Is.LessThan(1e-12));
            for (int i = 0; i < 7 + coefficients; i++)
            {
                double step = 1e-6 * Math.Max(1, Math.Abs(i < 7 ? values[i] : 1));
                Vector2D slope = (Moved(values, lens, i, step) - Moved(values, lens, i, -step)) * (0.5 / step);
                Vector2D analytic = i < 3 ? new Vector2D(byPoint[i], byPoint[3 + i])
                    : i < 7 ? new Vector2D(byPinhole[i - 3], byPinhole[4 + i - 3])
                    : new Vector2D(byDistortion[i - 7], byDistortion[coefficients + i - 7]);
                Assert.That((slope - analytic).Length, Is.LessThan(1e-6 * Math.Max(1, analytic.Length)), "parameter " + i);
            }
        }

        [Test]
        public void LensCamera_WhatLiesBehindTheCamera_HasNoPixel()
        {
            LensCamera camera = Camera(new double[] { 0, 0, 0, 900, 900, 960, 540 }, Plain);
            Assert.That(camera.TryProject(new Vector3D(0.1, 0.1, 0), out _), Is.False);
            Assert.That(camera.TryProject(new Vector3D(0.1, 0.1, -1), out _), Is.False);
            Assert.That(camera.TryProject(new Vector3D(0.1, 0.1, double.NaN), out _), Is.False);
        }

        [Test]
        public void LensCamera_PixelThatNoRayReaches_IsRefused()
        {
            LensCamera camera = Camera(new double[] { 0, 0, 0, 900, 900, 960, 540 }, new[] { -0.3, 0, 0, 0, 0.0 });

            // r (1 − 0.3 r²) has its largest value 0.7027 at r = 1.0541: beyond lies no ray.
            Assert.That(camera.Distortion.MaxRadius, Is.EqualTo(Math.Sqrt(1 / 0.9)).Within(1e-9));
            Assert.That(camera.TryUnproject(new Vector2D(960 + 900 * 0.7026, 540), out Vector2D ray), Is.True);
            Assert.That(ray.X, Is.EqualTo(1.041).Within(2e-3));
            Assert.That(camera.TryUnproject(new Vector2D(960 + 900 * 0.7029, 540), out _), Is.False);
            Assert.That(camera.TryUnproject(new Vector2D(double.NaN, 540), out _), Is.False);
            Assert.That(camera.TryProject(new Vector2D(1.06, 0), out _), Is.False);
        }

        [Test]
        public void BrownDistortion_OpenCvCoefficients_ComeBack()
        {
            Assert.That(BrownDistortion.FromOpenCv(Strong).ToOpenCv(), Is.EqualTo(Strong));
            Assert.That(BrownDistortion.FromOpenCv(Plain).ToOpenCv()[..5], Is.EqualTo(Plain));
            Assert.That(() => BrownDistortion.FromOpenCv(new double[4]), Throws.ArgumentException);
            Assert.That(() => BrownDistortion.FromOpenCv(new[] { 0, 0, 0, 0, double.NaN }), Throws.ArgumentException);
        }

        private static Vector2D Moved(double[] values, double[] lens, int parameter, double step)
        {
            double[] v = (double[])values.Clone(), d = (double[])lens.Clone();
            if (parameter < 7)
                v[parameter] += step;
            else
                d[parameter - 7] += step;
            Assert.That(Camera(v, d).TryProject(Point(v), out Vector2D pixel), Is.True);
            return pixel;
        }

        private static LensCamera Camera(double[] v, double[] lens) => new LensCamera(new PinholeCamera(v[3], v[4], v[5], v[6], 1920, 1080), BrownDistortion.FromOpenCv(lens));

        private static Vector3D Point(double[] v) => new Vector3D(v[0], v[1], v[2]);
    }
}
