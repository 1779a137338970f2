using System;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Poses of screens and boards, with known truth and beside OpenCV's converged results.</summary>
    [Category("Reference")]
    public sealed class PlanarPoseReferenceTests
    {
        [Test]
        public void TryEstimate_AllCases_AgreeWithTruthAndReference()
        {
            double worstM = 0, worstRad = 0, worstExcessPx = double.NegativeInfinity;
            int cases = 0, ambiguous = 0;
            foreach (JToken test in StereoReference.Load("camera_models", "pnp_planar.json")["cases"]!)
            {
                string name = (string)test["id"]!;
                LensCamera camera = StereoReference.Camera(test["K"]!, test["dist"]!, (int)test["image_size"]![0]!, (int)test["image_size"]![1]!);
                BoardView view = StereoReference.View(name, StereoReference.Points(test["object_points"]!), StereoReference.Points(test["image_points"]!));
                Assert.That(PlanarPoseEstimator.TryEstimate(view, camera, out PlanarPose? found, out string reason), Is.True, reason);
                double rms = (double)test["refined_converged"]!["rms_px"]!;
                if ((double)test["noise_sigma_px"]! == 0)
                {
                    double[] t = StereoReference.Numbers(test["true"]!["tvec"]!), r = StereoReference.Numbers(test["true"]!["rvec"]!);
                    var axis = new Vector3D(r[0], r[1], r[2]);
                    worstM = Math.Max(worstM, (found!.Pose.Position - new Vector3D(t[0], t[1], t[2])).Length);
                    worstRad = Math.Max(worstRad, StereoReference.AngleRad(found.Pose.Rotation, Rotation3D.AboutAxis(axis, axis.Length)));
                }

                worstExcessPx = Math.Max(worstExcessPx, found!.RmsPx - rms);
                double[] closed = test["ippe"]!.Select(pose => (double)pose["rms_px"]!).OrderBy(v => v).ToArray();
                Assert.That(found.IsAmbiguous, Is.EqualTo(closed[1] < 2 * closed[0]), name + " " + found.RmsPx + " " + found.OtherRmsPx + " " + closed[0] + " " + closed[1]);
                ambiguous += found.IsAmbiguous ? 1 : 0;
                cases++;
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"{cases} poses: worst {worstM:E2} m, {worstRad:E2} rad, rms above the reference by {worstExcessPx:E2} px at most, {ambiguous} ambiguous"));
            Assert.That(worstM, Is.LessThanOrEqualTo(1e-6));
            Assert.That(worstRad, Is.LessThanOrEqualTo(1e-6));
            Assert.That(worstExcessPx, Is.LessThanOrEqualTo(1e-6));
        }
    }
}
