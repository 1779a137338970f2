using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class LensTableTests
    {
        // Of a real depth camera's colour lens at 1920×1080.
        private static readonly LensCamera Camera = new LensCamera(new PinholeCamera(924, 923, 952, 544, 1920, 1080),
            BrownDistortion.FromOpenCv(new[] { -1.0576, -1.3993, 0.00069, -0.000012, 1.7509, -1.1485, -1.1924, 1.6221 }));

        [Test]
        public void LensTable_RaysProjectedAgain_MissByNoMoreThanAsked()
        {
            LensTable table = LensTable.Within(Camera);
            var random = new Random(3);
            double worst = 0;
            for (int i = 0; i < 50000; i++)
            {
                var pixel = new Vector2D(random.NextDouble() * 1920 - 0.5, random.NextDouble() * 1080 - 0.5);
                if (!table.TryRay(pixel, out Vector2D ray))
                    continue;
                Assert.That(Camera.TryProject(ray, out Vector2D again), Is.True);
                worst = Math.Max(worst, (again - pixel).Length);
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"cell {table.CellPx} px, worst {worst:G3} px"));
            Assert.That(worst, Is.GreaterThan(0).And.LessThanOrEqualTo(0.01));
        }

        [Test]
        [Category("Long")]
        public void LensTable_PixelsBesideThePictureOrWithoutRay_AreRefused()
        {
            LensTable table = LensTable.Within(Camera);
            foreach (var pixel in new[] { new Vector2D(-40, 5), new Vector2D(5, -40), new Vector2D(1990, 5), new Vector2D(5, 1150), new Vector2D(double.NaN, 5), new Vector2D(5, double.PositiveInfinity) })
                Assert.That(table.TryRay(pixel, out _), Is.False);
            var folding = new LensCamera(new PinholeCamera(500, 500, 960, 540, 1920, 1080), BrownDistortion.FromOpenCv(new double[] { -0.3, 0, 0, 0, 0 }));
            table = LensTable.Within(folding);
            Assert.That(table.TryRay(new Vector2D(5, 5), out _), Is.False);
            Assert.That(table.TryRay(new Vector2D(960, 540), out Vector2D middle), Is.True);
            Assert.That(middle.Length, Is.LessThan(1e-6));
        }

        [Test]
        public void LensTable_ManyAtOnce_AreTheSameAsOneByOne()
        {
            LensTable table = LensTable.Within(Camera);
            var random = new Random(4);
            var pixels = new Vector2D[5000];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = new Vector2D(random.NextDouble() * 2000 - 40, random.NextDouble() * 1160 - 40);
            pixels[7] = new Vector2D(double.NaN, 3);
            pixels[8] = new Vector2D(3, double.NegativeInfinity);
            var rays = new Vector2D[pixels.Length];
            table.Rays(pixels, rays);
            for (int i = 0; i < pixels.Length; i++)
            {
                bool isFound = table.TryRay(pixels[i], out Vector2D ray);
                Assert.That(rays[i].IsFinite, Is.EqualTo(isFound));
                Assert.That(!isFound || rays[i].Equals(ray), Is.True, pixels[i].ToString());
            }
        }

        [Test]
        public void LensTable_LookingUp_AllocatesNothing()
        {
            LensTable table = LensTable.Within(Camera);
            Vector2D[] pixels = { new Vector2D(3, 4), new Vector2D(900, 800), new Vector2D(-9, 0) }, rays = new Vector2D[3];
            Assert.That(Allocation.Of(() => table.Rays(pixels, rays)), Is.Zero);
            Assert.That(rays[0].IsFinite && rays[1].IsFinite, Is.True);
            Assert.That(rays[2].IsFinite, Is.False);
        }
    }
}
