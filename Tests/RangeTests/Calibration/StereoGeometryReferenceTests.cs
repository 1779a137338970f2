using System;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Rigs with known truth: direction of the pose between the cameras, E, F, triangulation, rectification.</summary>
    [Category("Reference")]
    public sealed class StereoGeometryReferenceTests
    {
        [Test]
        public void StereoRig_PointsAndRays_GoTheWayOfTheReference()
        {
            double worstPx = 0, worstBack = 0, wrongWay = double.PositiveInfinity;
            ForEach((rig, test, name) =>
            {
                Vector2D[] left = StereoReference.Points(test["px1"]!), right = StereoReference.Points(test["px2"]!);
                for (int i = 0; i < left.Length; i++)
                {
                    Vector3D inLeft = Point(test["points_cam1"]![i]!), inRight = rig.LeftToRight.TransformPoint(inLeft);
                    Assert.That(rig.Left.TryProject(inLeft, out Vector2D p) && rig.Right.TryProject(inRight, out Vector2D q) && Grow(ref worstPx, Math.Max((p - left[i]).Length, (q - right[i]).Length)), Is.True, name);
                    worstBack = Math.Max(worstBack, (rig.RightToLeft(inRight) - inLeft).Length);
                    wrongWay = Math.Min(wrongWay, (rig.LeftToRight.TransformPoint(inRight) - inLeft).Length);
                }
            });
            TestContext.Out.WriteLine(FormattableString.Invariant($"projection {worstPx:E2} px, there and back {worstBack:E2} m, the wrong direction would be off by at least {wrongWay:F4} m"));
            Assert.That(worstPx, Is.LessThanOrEqualTo(1e-6));
            Assert.That(worstBack, Is.LessThanOrEqualTo(1e-12));
            Assert.That(wrongWay, Is.GreaterThan(1e-3));
        }

        [Test]
        public void EpipolarGeometry_AllRigs_AgreesWithTheReference()
        {
            double worstE = 0, worstF = 0;
            ForEach((rig, test, name) =>
            {
                var found = new EpipolarGeometry(rig);
                worstE = Math.Max(worstE, Deviation(found.Essential, StereoReference.Numbers(test["E"]!)));
                worstF = Math.Max(worstF, Deviation(found.Fundamental, StereoReference.Numbers(test["F_normalised_33"]!)));
            });
            TestContext.Out.WriteLine(FormattableString.Invariant($"E within {worstE:E2}, F within {worstF:E2} of its largest element"));
            Assert.That(worstE, Is.LessThanOrEqualTo(1e-9));
            Assert.That(worstF, Is.LessThanOrEqualTo(1e-9));
        }

        [Test]
        public void Triangulation_NoisyRays_AgreesWithTheReference()
        {
            double worst = 0;
            int points = 0;
            ForEach((rig, test, name) =>
            {
                Vector2D[] left = StereoReference.Points(test["rays1"]!), right = StereoReference.Points(test["rays2"]!);
                for (int i = 0; i < left.Length; i++, points++)
                {
                    Assert.That(Triangulation.TryTriangulate(left[i], right[i], rig.LeftToRight, out Vector3D found), Is.True, name);
                    worst = Math.Max(worst, (found - Point(test["triangulated_dlt"]![i]!)).Length);
                }
            });
            TestContext.Out.WriteLine(FormattableString.Invariant($"{points} points within {worst:E2} m"));
            Assert.That(worst, Is.LessThanOrEqualTo(1e-9));
        }

        [Test]
        public void StereoRectification_AllRigs_AgreesWithTheReference()
        {
            double worstRad = 0, worstFocal = 0, worstShift = 0;
            int rectified = 0, centered = 0;
            ForEach((rig, test, name) =>
            {
                if (test["rectify"] is not JObject expected)
                    return;
                rectified++;
                StereoRectification found = StereoRectification.Of(rig);
                double[] p2 = StereoReference.Numbers(expected["P2"]!);
                worstRad = Math.Max(worstRad, Math.Max(Turn(found.Left, expected["R1"]!), Turn(found.Right, expected["R2"]!)));
                worstFocal = Math.Max(worstFocal, Math.Abs(found.FocalPx - p2[0]) / p2[0]);
                worstShift = Math.Max(worstShift, Math.Abs(found.ShiftPx - p2[found.IsVertical ? 7 : 3]) / Math.Abs(found.ShiftPx));
                double center = Math.Max(Math.Abs(found.CenterPx.X - p2[2]), Math.Abs(found.CenterPx.Y - p2[6]));
                centered += center < 0.1 ? 1 : 0;
            });
            TestContext.Out.WriteLine(FormattableString.Invariant($"{rectified} rigs: turns within {worstRad:E2} rad, focal length {worstFocal:E2}, shift {worstShift:E2}, centre within 0.1 px in {centered} (the reference undistorts corners inexactly)"));
            Assert.That(worstRad, Is.LessThanOrEqualTo(1e-7));
            Assert.That(worstFocal, Is.LessThanOrEqualTo(1e-9));
            Assert.That(worstShift, Is.LessThanOrEqualTo(1e-9));
        }

        private static void ForEach(Action<StereoRig, JToken, string> check)
        {
            int count = 0;
            foreach (JToken test in StereoReference.Load("camera_models", "stereo_geometry.json")["cases"]!)
            {
                double[] t = StereoReference.Numbers(test["T"]!);
                Assert.That(Rotation3D.TryFromMatrix(StereoReference.Numbers(test["R"]!), out Rotation3D rotation), Is.True);
                int width = (int?)test["rectify"]?["image_size"]![0] ?? 1024, height = (int?)test["rectify"]?["image_size"]![1] ?? 1024;
                var rig = new StereoRig(StereoReference.Camera(test["K1"]!, test["dist1"]!, width, height), StereoReference.Camera(test["K2"]!, test["dist2"]!, width, height), new Pose(new Vector3D(t[0], t[1], t[2]), rotation));
                check(rig, test, (string)test["id"]!);
                count++;
            }

            Assert.That(count, Is.GreaterThan(0));
        }

        private static bool Grow(ref double worst, double value)
        {
            worst = Math.Max(worst, value);
            return true;
        }

        private static double Turn(Rotation3D found, JToken expected)
        {
            Assert.That(Rotation3D.TryFromMatrix(StereoReference.Numbers(expected), out Rotation3D rotation), Is.True);
            return StereoReference.AngleRad(found, rotation);
        }

        private static double Deviation(double[] found, double[] expected) => found.Zip(expected, (a, b) => Math.Abs(a - b)).Max() / expected.Max(Math.Abs);

        private static Vector3D Point(JToken p) => new((double)p[0]!, (double)p[1]!, (double)p[2]!);
    }
}
