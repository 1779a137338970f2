using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class RangeCalibrationFileTests
    {
        private static readonly string Valid = RangeCalibrationFile.Format(Example());

        [Test]
        public void RangeCalibrationFile_WrittenAndRead_IsTheSame()
        {
            RangeCalibration read = RangeCalibrationFile.Parse(Valid, "test");
            RangeCalibration written = Example();
            var pixel = new Vector2D(400, 300);
            Assert.That((read.Screen.ToScreenM(pixel) - written.Screen.ToScreenM(pixel)).Length, Is.LessThan(1e-9));
            var point = new Vector3D(100, 200, 1500);
            Assert.That((read.HandCamera!.ToScreenM(point) - written.HandCamera!.ToScreenM(point)).Length, Is.LessThan(1e-9));
            Assert.That(read.ImageWidth, Is.EqualTo(1280));
        }

        [Test]
        public void RangeCalibrationFile_WithLensAndUncertainty_IsTheSame()
        {
            RangeCalibration written = WithLens();
            RangeCalibration read = RangeCalibrationFile.Parse(RangeCalibrationFile.Format(written), "test");
            var pixel = new Vector2D(400, 300);
            Assert.That((read.Screen.ToScreenM(pixel) - written.Screen.ToScreenM(pixel)).Length, Is.LessThan(1e-9));
            Covariance2D expected = written.Screen.ToScreenMm2(pixel, default), found = read.Screen.ToScreenMm2(pixel, default);
            Assert.That(expected.XX, Is.GreaterThan(1e-4));
            Assert.That(new[] { found.XX, found.XY, found.YY }, Is.EqualTo(new[] { expected.XX, expected.XY, expected.YY }).Within(1e-6 * expected.XX));
        }

        [TestCase(7, 7)]
        [TestCase(1000, 200)]
        public void RangeCalibrationFile_Residuals_AreKeptAsFarAsNeeded(int count, int kept)
        {
            RangeCalibration example = Example();
            var residuals = new ScreenResidual[count];
            for (int i = 0; i < count; i++)
                residuals[i] = new ScreenResidual(new Vector2D(i * 0.001, 1), new Vector2D(0.25, -i));
            string text = RangeCalibrationFile.Format(new RangeCalibration(example.Screen, 1280, 720, null, false, residuals));
            RangeCalibration read = RangeCalibrationFile.Parse(text, "test");
            Assert.That(read.Residuals, Has.Count.EqualTo(kept));
            ScreenResidual last = read.Residuals[kept - 1];
            Assert.That(last.OffMm.Y, Is.EqualTo(-1000 * last.ScreenM.X).Within(1e-6));
            foreach (string bad in new[] { "7", "[[1,2,3]]", "[[1,2,3,\"x\"]]" })
                Assert.Throws<InputException>(() => RangeCalibrationFile.Parse(Valid.Replace("\"v\": 1", "\"v\": 1, \"residuals_mm\": " + bad), "test"));
        }

        [TestCase("\"v\": 1", "\"v\": 2", "newer release")]
        [TestCase("\"v\": 1", "\"v\": 1e99", "v is no version")]
        [TestCase("\"v\": 1", "\"v\": 0", "v is no version")]
        [TestCase("\"dist\"", "\"distortion\"", "dist")]
        [TestCase("\"K\"", "\"k\"", "K")]
        [TestCase("-0.28", "\"x\"", "dist, element 1")]
        [TestCase("-0.28", "-28.0", "no screen in the picture")]
        [TestCase("905.0", "-905.0", "focal")]
        [TestCase("\"corners_cov_px2\": [", "\"corners_cov_px2\": [[1],", "corners_cov_px2")]
        public void RangeCalibrationFile_BadLensOrVersion_IsNamedInOneLine(string good, string bad, string named)
        {
            string valid = RangeCalibrationFile.Format(WithLens()), text = valid.Replace(good, bad);
            Assert.That(text, Is.Not.EqualTo(valid));
            InputException? problem = Assert.Throws<InputException>(() => RangeCalibrationFile.Parse(text, "screen.json"));
            Assert.That(problem!.Message, Does.StartWith("screen.json: ").And.Contain(named));
            Assert.That(problem.Message, Does.Not.Contain("\n"));
        }

        [Test]
        public void RangeCalibrationFile_BrokenBytes_AreRefusedOrRead()
        {
            byte[] valid = System.Text.Encoding.UTF8.GetBytes(RangeCalibrationFile.Format(WithLens()));
            var random = new Random(5);
            for (int i = 0; i < 400; i++)
            {
                var bytes = (byte[])valid.Clone();
                for (int change = random.Next(1, 4); change > 0; change--)
                    bytes[random.Next(bytes.Length)] = (byte)random.Next(32, 127);
                try
                {
                    RangeCalibrationFile.Parse(System.Text.Encoding.UTF8.GetString(bytes, 0, i % 4 == 0 ? random.Next(bytes.Length) : bytes.Length), "screen.json");
                }
                catch (InputException problem)
                {
                    Assert.That(problem.Message, Does.Not.Contain("\n"));
                }
            }
        }

        [TestCase("\"kind\": \"screen\"", "\"kind\": \"stereo\"", "kind")]
        [TestCase("3.73", "\"NaN\"", "screen_m")]
        [TestCase("3.73", "NaN", "screen_m")]
        [TestCase("3.73", "-1", "screen_m")]
        [TestCase("1280", "0", "image_size")]
        [TestCase("\"H\"", "\"h\"", "H")]
        [TestCase("\"v\": 1,", "\"v\": 1", "line")]
        public void RangeCalibrationFile_BadField_IsNamedInOneLine(string good, string bad, string named)
        {
            string text = Valid.Replace(good, bad);
            Assert.That(text, Is.Not.EqualTo(Valid));
            InputException? problem = null;
            try
            {
                RangeCalibrationFile.Parse(text, "screen.json");
            }
            catch (InputException caught)
            {
                problem = caught;
            }

            Assert.That(problem, Is.Not.Null);
            Assert.That(problem!.Message, Does.StartWith("screen.json: ").And.Contain(named));
            Assert.That(problem.Message, Does.Not.Contain("\n"));
        }

        [Test]
        public void Rotation3D_FromMatrixOfAnyRotation_TurnsAlike()
        {
            foreach (double angle in new[] { 0.0, 0.4, 2.0, Math.PI, -3.0 })
            foreach (var axis in new[] { new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1), new Vector3D(1, -2, 3) })
            {
                Rotation3D expected = Rotation3D.AboutAxis(axis, angle);
                Vector3D x = expected * new Vector3D(1, 0, 0), y = expected * new Vector3D(0, 1, 0), z = expected * new Vector3D(0, 0, 1);
                Assert.That(Rotation3D.TryFromMatrix(new[] { x.X, y.X, z.X, x.Y, y.Y, z.Y, x.Z, y.Z, z.Z }, out Rotation3D rotation), Is.True);
                var v = new Vector3D(0.3, -0.2, 0.7);
                Assert.That((rotation * v - expected * v).Length, Is.LessThan(1e-9));
            }

            Assert.That(Rotation3D.TryFromMatrix(new double[] { 1, 0, 0, 0, 1, 0, 0, 0, -1 }, out _), Is.False);
        }

        private static RangeCalibration WithLens()
        {
            var camera = new LensCamera(new PinholeCamera(905, 906, 640, 360, 1280, 720), BrownDistortion.FromOpenCv(new[] { -0.28, 0.09, 0.001, -0.0007, -0.012 }));
            var screen = new ScreenGeometry(new Homography(new[] { 0.003, 0.0001, -0.4, 0.0002, 0.003, -0.3, 1e-5, 2e-5, 1 }), new Vector2D(3.73, 2.26), camera);
            var covariance = new double[8, 8];
            for (int i = 0; i < 8; i++)
                covariance[i, i] = 0.04;
            Assert.That(HomographyUncertainty.TryFromAnchors(screen.ImageToScreen.Inverse, ScreenGeometry.CornersOf(screen.ScreenSizeM), covariance, out HomographyUncertainty? uncertainty, out string reason), Is.True, reason);
            return new RangeCalibration(new ScreenGeometry(screen.ImageToScreen, screen.ScreenSizeM, camera, uncertainty), 1280, 720, null);
        }

        private static RangeCalibration Example()
        {
            var screen = new ScreenGeometry(new Homography(new[] { 0.003, 0.0001, -0.4, 0.0002, 0.003, -0.3, 1e-5, 2e-5, 1 }), new Vector2D(3.73, 2.26));
            var hand = new HandCamera(
                new PinholeCamera(504, 505, 320, 288, 640, 576),
                new Pose(new Vector3D(1865, 2400, 100), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), 3.0)));
            return new RangeCalibration(screen, 1280, 720, hand);
        }
    }
}
