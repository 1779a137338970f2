using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    /// <summary>A lens found from the screen's own points: what it and the homography say together of their uncertainty.</summary>
    public sealed class PlaneLensTests
    {
        private const int Width = 1280, Height = 720, Trials = 250;
        private const double NoisePx = 0.1;

        /// <summary>Squared length of a normal plane vector in standard deviations that 90 % keep to: chi squared, two degrees of freedom.</summary>
        private const double NinetyPercent = 4.605;

        private static readonly Vector2D Size = new Vector2D(3.2, 1.8);

        [TestCase(-0.2, -0.05, -0.02, 0.06, 0.85, 0.95)]
        [TestCase(-0.05, 0.05, 0, 0, 0.85, 0.95)]
        [TestCase(-0.008, 0.008, -0.004, 0.004, 0.85, 0.97)]
        [TestCase(0, 0, 0, 0, 0.85, 0.97)]
        [Category("Long")]
        public void PlaneLens_ManyRooms_NinetyPercentEllipsesHoldNinetyPercent(double leastK1, double mostK1, double leastK2, double mostK2, double least, double most)
        {
            var random = new Random(5);
            int inside = 0, insideWithoutLens = 0, asked = 0;
            for (int trial = 0; trial < Trials; trial++)
            {
                ScreenGeometry truth = Room(random, Between(random, leastK1, mostK1), Between(random, leastK2, mostK2));
                ScreenGeometry fitted = Calibrated(truth, random);
                Assert.That(ScreenGeometry.TryFit(Seen(truth, new Random(trial), NoisePx), Grid(), Size, fitted.Camera, NoisePx, out ScreenGeometry? given, out _), Is.True);
                for (int i = 0; i < 9; i++, asked++)
                {
                    Vector2D place = new Vector2D((0.04 + 0.46 * (i % 3)) * Size.X, (0.04 + 0.46 * (i / 3)) * Size.Y), pixel = truth.ToImagePx(place);
                    Vector2D off = (fitted.ToScreenM(pixel) - place) * 1000;
                    inside += Squared(off, fitted.ToScreenMm2(pixel, default)) < NinetyPercent ? 1 : 0;
                    insideWithoutLens += Squared(off, given!.ToScreenMm2(pixel, default)) < NinetyPercent ? 1 : 0;
                }
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"inside {100.0 * inside / asked:F1} %, without the lens's share {100.0 * insideWithoutLens / asked:F1} %"));
            Assert.That(inside / (double)asked, Is.InRange(least, most));
        }

        [Test]
        public void PlaneLens_Uncertainty_SurvivesTheFile()
        {
            var random = new Random(8);
            ScreenGeometry truth = Room(random, -0.15, 0.03), fitted = Calibrated(truth, random);
            string json = RangeCalibrationFile.Format(new RangeCalibration(fitted, Width, Height, null));
            ScreenGeometry read = RangeCalibrationFile.Parse(json, "x").Screen;
            Assert.That((fitted.IsFocalLengthKnown, read.IsFocalLengthKnown), Is.EqualTo((false, false)));
            foreach (Vector2D place in new[] { default, Size * 0.5, Size })
            {
                Vector2D pixel = truth.ToImagePx(place);
                Covariance2D before = fitted.ToScreenMm2(pixel, Covariance2D.Isotropic(0.1)), after = read.ToScreenMm2(pixel, Covariance2D.Isotropic(0.1));
                Assert.That(new[] { after.XX, after.XY, after.YY }, Is.EqualTo(new[] { before.XX, before.XY, before.YY }).Within(1e-6 * before.XX));
            }
        }

        [Test]
        public void PlaneLens_OlderFileWithoutTheJointCovariance_IsReadWithWhatItSays()
        {
            var random = new Random(8);
            string json = RangeCalibrationFile.Format(new RangeCalibration(Calibrated(Room(random, -0.15, 0.03), random), Width, Height, null));
            string older = json.Replace("\"corners_lens_cov\"", "\"unknown\"").Replace("\"focal_known\": false", "\"lens_found\": true");
            ScreenGeometry read = RangeCalibrationFile.Parse(older, "x").Screen;
            Assert.That((read.Uncertainty!.LensCoefficients, read.IsFocalLengthKnown), Is.EqualTo((0, false)));
            Assert.That(Assert.Throws<InputException>(() => RangeCalibrationFile.Parse(json.Replace("\"corners_lens_cov\": [", "\"corners_lens_cov\": [ 1,"), "x"))!.Message, Does.Contain("corners_lens_cov"));
        }

        [Test]
        public void PlaneLens_UncertaintyOfAShot_AllocatesNothing()
        {
            var random = new Random(8);
            ScreenGeometry fitted = Calibrated(Room(random, -0.15, 0.03), random);
            Assert.That(Allocation.Of(() => fitted.ToScreenMm2(new Vector2D(640, 300), Covariance2D.Isotropic(0.1))), Is.Zero);
        }

        [Test]
        public void PlaneLens_ElevenPoints_GiveNone() =>
            Assert.That(PlaneLens.TryFind(Grid().AsSpan(0, 11), Seen(Room(new Random(1), -0.1, 0), new Random(2), 0).AsSpan(0, 11), Width, Height, 0.1, out _), Is.False);

        private static ScreenGeometry Calibrated(ScreenGeometry truth, Random random)
        {
            Vector2D[] seen = Seen(truth, random, NoisePx);
            Assert.That(PlaneLens.TryFind(Grid(), seen, Width, Height, NoisePx, out PlaneLens? lens), Is.True);
            Assert.That(ScreenGeometry.TryFit(seen, Grid(), Size, lens!.Camera, NoisePx, out ScreenGeometry? fitted, out string reason), Is.True, reason);
            return new ScreenGeometry(fitted!.ImageToScreen, Size, lens.Camera, lens.Uncertainty, isFocalLengthKnown: false);
        }

        /// <summary>Some keystone, some size, the lens's true focal length other than the nominal one.</summary>
        private static ScreenGeometry Room(Random random, double k1, double k2)
        {
            var corners = new Vector2D[4];
            double share = Between(random, 0.55, 0.9);
            for (int i = 0; i < 4; i++)
            {
                Vector2D corner = ScreenGeometry.CornersOf(new Vector2D(1, 1))[i] - new Vector2D(0.5, 0.5);
                corners[i] = new Vector2D(640 + corner.X * share * 1200 + Between(random, -60, 60), 360 + corner.Y * share * 690 + Between(random, -30, 30));
            }

            Assert.That(HomographyEstimator.TryFit(corners, ScreenGeometry.CornersOf(Size), out Homography toScreen, out _), Is.True);
            return new ScreenGeometry(toScreen, Size, new LensCamera(new PinholeCamera(1150, 1150, 639.5, 359.5, Width, Height), new BrownDistortion(new[] { k1, k2, 0 }, 0, 0)));
        }

        private static Vector2D[] Grid()
        {
            var places = new Vector2D[120];
            for (int i = 0; i < places.Length; i++)
                places[i] = new Vector2D((i % 15 + 1) / 16.0 * Size.X, (i / 15 + 1) / 9.0 * Size.Y);
            return places;
        }

        private static Vector2D[] Seen(ScreenGeometry truth, Random random, double noisePx)
        {
            Vector2D[] places = Grid();
            for (int i = 0; i < places.Length; i++)
                places[i] = truth.ToImagePx(places[i]) + new Vector2D(Noise(random), Noise(random)) * noisePx;
            return places;
        }

        private static double Squared(Vector2D off, Covariance2D c) => (c.YY * off.X * off.X - 2 * c.XY * off.X * off.Y + c.XX * off.Y * off.Y) / (c.XX * c.YY - c.XY * c.XY);

        private static double Between(Random random, double low, double high) => low + (high - low) * random.NextDouble();

        private static double Noise(Random random) => Math.Sqrt(-2 * Math.Log(1 - random.NextDouble())) * Math.Cos(2 * Math.PI * random.NextDouble());
    }
}
