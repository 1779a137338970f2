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
