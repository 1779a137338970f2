using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Cameras determined from stored corners of real pictures, beside OpenCV's result on the same corners.</summary>
    [Category("Reference")]
    public sealed class CameraCalibratorReferenceTests
    {
        private const double RmsTolerancePx = 1e-3;
        private const double ToleranceInDeviations = 0.3;

        [TestCase("win5")]
        [TestCase("win11")]
        public void TryCalibrate_StoredCorners_AgreesWithTheReference(string window)
        {
            List<BoardPair> pairs = StereoReference.Pairs(StereoReference.Load("stereo", "opencv_9x6", "corners_" + window + ".json"));
            JObject reference = StereoReference.Load("stereo", "opencv_9x6", "reference_" + window + ".json");
            foreach (JProperty model in ((JObject)reference["mono"]!).Properties())
            foreach (JProperty side in ((JObject)model.Value).Properties())
            {
                List<BoardView> views = pairs.Select(pair => side.Name == "left" ? pair.Left : pair.Right).ToList();
                Compare(views, (int)reference["image_size"]![0]!, (int)reference["image_size"]![1]!, model.Name, side.Value, model.Name + " " + side.Name);
            }
        }

        [Test]
        public void TryCalibrate_PartsOfABoardInAWideCamera_AgreesWithTheReference()
        {
            JObject corners = StereoReference.Load("stereo", "azure_kinect_charuco", "color_corners.json");
            JObject reference = StereoReference.Load("stereo", "azure_kinect_charuco", "reference.json");
            foreach (JProperty model in ((JObject)reference["mono_color"]!).Properties())
                Compare(StereoReference.SubsetViews(corners), (int)corners["image_size"]![0]!, (int)corners["image_size"]![1]!, model.Name, model.Value, model.Name);
        }

        private static void Compare(List<BoardView> views, int width, int height, string model, JToken reference, string name)
        {
            Assert.That(CameraCalibrator.TryCalibrate(views, width, height, StereoReference.Model(model), true, out CameraCalibration? found, out string reason), Is.True, reason);
            double[] k = StereoReference.Numbers(reference["K"]!), deviations = StereoReference.Numbers(reference["std_fx_fy_cx_cy"]!), perView = StereoReference.Numbers(reference["per_view_rms"]!);
            double[] expected = { k[0], k[4], k[2], k[5] }, parameters = CameraParameters.Of(found!.Camera);
            double worst = Enumerable.Range(0, 4).Max(i => Math.Abs(parameters[i] - expected[i]) / deviations[i]);
            TestContext.Out.WriteLine(FormattableString.Invariant($"{name}: rms {found.RmsPx:F6} against {(double)reference["rms"]!:F6} px, fx fy cx cy within {worst:F4} deviations"));
            TestContext.Out.WriteLine("  std " + string.Join(" ", found.StandardDeviations.Take(4).Select(d => d.ToString("F4"))) + " against " + string.Join(" ", deviations));
            Assert.That(found.LeftOut, Is.Empty);
            Assert.That(found.RmsPx, Is.EqualTo((double)reference["rms"]!).Within(RmsTolerancePx), name);
            Assert.That(worst, Is.LessThanOrEqualTo(ToleranceInDeviations), name);
            for (int i = 0; i < 4; i++)
                Assert.That(found.StandardDeviations[i], Is.EqualTo(deviations[i]).Within(5).Percent, name);
            for (int i = 0; i < perView.Length; i++)
                Assert.That(found.PerViewRmsPx[i], Is.EqualTo(perView[i]).Within(10 * RmsTolerancePx), found.Views[i].Name);
        }
    }
}
