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

        // Tables of all cameras would take seconds.
        private const int TableEvery = 10;

        [Test]
        public void LensCamera_ProjectAndUnproject_AgreeWithTheReference()
        {
            Deviation projection = new("camera_models.json, rays to pixels"), posed = new("camera_models.json, posed points to pixels");
            Deviation inversion = new("camera_models.json, pixels to rays, projected again"), rays = new("camera_models.json, pixels to rays, at the focal length");
            Deviation fold = new("camera_models.json, radius of the fold");
            foreach (JToken test in Cases())
            {
                LensCamera camera = Camera(test);
                for (int i = 0; i < test["normalised"]!.Count(); i++)
                {
                    Vector2D ray = Point(test["normalised"]![i]!), pixel = Point(test["projected_px"]![i]!);
                    projection.Add(camera.TryProject(ray, out Vector2D projected) ? (projected - pixel).Length : double.NaN);
                    bool isFound = camera.TryUnproject(pixel, out Vector2D found);
                    camera.TryProject(found, out Vector2D again);
                    inversion.Add(isFound ? (again - pixel).Length : double.NaN);
                    rays.Add((found - ray).Length * camera.Pinhole.FocalXPx);
                }

                JToken pose = test["pose"]!;
                Vector3D vector = Space(pose["rvec"]!), position = Space(pose["tvec"]!);
                var camFromObject = new Pose(position, Rotation3D.FromVector(vector));
                for (int i = 0; i < pose["object_points"]!.Count(); i++)
                {
                    bool isSeen = camera.TryProject(camFromObject.TransformPoint(Space(pose["object_points"]![i]!)), out Vector2D projected);
                    posed.Add(isSeen ? (projected - Point(pose["projected_px"]![i]!)).Length : double.NaN);
                }

                // The reference looked for the fold in steps of its own, up to an end of its own.
                double known = (double)test["max_monotone_radius"]!;
                if (camera.Distortion.MaxRadius < known)
                    fold.Add(known - camera.Distortion.MaxRadius);
            }

            projection.AssertWithin(ProjectionTolerancePx, "px");
            posed.AssertWithin(ProjectionTolerancePx, "px");
            inversion.AssertWithin(InversionTolerancePx, "px");
            rays.AssertWithin(InversionTolerancePx, "px");
            fold.AssertWithin(0.02, "of the focal length");
        }

        [Test]
        public void LensTable_OfReferenceCameras_MissesByAHundredthOfAPixelAtMost()
        {
            var deviation = new Deviation("camera_models.json, look-up in a table");
            foreach (JToken test in Cases().Where((_, number) => number % TableEvery == 0))
            {
                LensCamera camera = Camera(test);
                LensTable table = LensTable.Within(camera);
                foreach (JToken pixel in test["projected_px"]!)
                {
                    if (table.TryRay(Point(pixel), out Vector2D ray) && camera.TryProject(ray, out Vector2D again))
                        deviation.Add((again - Point(pixel)).Length);
                }
            }

            deviation.AssertWithin(0.01, "px");
        }

        private static JToken Cases() => JObject.Parse(File.ReadAllText(TestFiles.Reference("camera_models", "camera_models.json")))["cases"]!;

        private static LensCamera Camera(JToken test)
        {
            double[] k = test["K"]!.SelectMany(row => row).Select(v => (double)v).ToArray();
            var pinhole = new PinholeCamera(k[0], k[4], k[2], k[5], (int)test["image_size"]![0]!, (int)test["image_size"]![1]!);
            return new LensCamera(pinhole, BrownDistortion.FromOpenCv(test["dist"]!.Select(v => (double)v).ToArray()));
        }

        private static Vector2D Point(JToken token) => new((double)token[0]!, (double)token[1]!);

        private static Vector3D Space(JToken token) => new((double)token[0]!, (double)token[1]!, (double)token[2]!);
    }
}
