using System.IO;
using System.Linq;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    /// <summary>Lenses against reference projections, half of them with coefficients of real depth cameras.</summary>
    [Category("Reference")]
    public sealed class LensReferenceTests
    {
        private const double ProjectionTolerancePx = 1e-9;
        private const double InversionTolerancePx = 1e-6;

        [Test]
        public void LensCamera_ProjectAndUnproject_AgreeWithTheReference()
        {
            int points = 0;
            foreach (JToken test in JObject.Parse(File.ReadAllText(TestFiles.Reference("camera_models", "camera_models.json")))["cases"]!)
            {
                double[] d = test["dist"]!.Select(v => (double)v).ToArray(), k = test["K"]!.SelectMany(row => row).Select(v => (double)v).ToArray();
                var camera = new LensCamera(new PinholeCamera(k[0], k[4], k[2], k[5], (int)test["image_size"]![0]!, (int)test["image_size"]![1]!), BrownDistortion.FromOpenCv(d));
                for (int i = 0; i < test["normalised"]!.Count(); i++, points++)
                {
                    Vector2D ray = Point(test["normalised"]![i]!), pixel = Point(test["projected_px"]![i]!);
                    string name = test["id"] + " point " + i;
                    Assert.That(camera.TryProject(ray, out Vector2D projected), Is.True, name);
                    Assert.That((projected - pixel).Length, Is.LessThanOrEqualTo(ProjectionTolerancePx), name);
                    Assert.That(camera.TryUnproject(pixel, out Vector2D found), Is.True, name);
                    Assert.That((found - ray).Length * k[0], Is.LessThanOrEqualTo(InversionTolerancePx), name);
                }
            }

            Assert.That(points, Is.GreaterThan(1000));
        }

        private static Vector2D Point(JToken token) => new((double)token[0]!, (double)token[1]!);
    }
}
