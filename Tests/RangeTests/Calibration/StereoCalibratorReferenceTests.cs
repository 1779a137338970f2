using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// Two cameras determined from stored corners of real picture pairs, beside OpenCV's result on the same corners. With free
    /// intrinsics only the error is compared: the reference stopped before the minimum (0.21535 px; OpenCV 4.6 and this one 0.21511).
    /// </summary>
    [Category("Reference")]
    public sealed class StereoCalibratorReferenceTests
    {
        private const double RmsTolerancePx = 1e-3;
        private const double TranslationTolerance = 1e-3;
        private const double RotationToleranceRad = 1e-4;

        [TestCase("win5")]
        [TestCase("win11")]
        public void TryCalibrate_StoredCorners_AgreesWithTheReference(string window)
        {
            List<BoardPair> pairs = StereoReference.Pairs(StereoReference.Load("stereo", "opencv_9x6", "corners_" + window + ".json"));
            JObject reference = StereoReference.Load("stereo", "opencv_9x6", "reference_" + window + ".json");
            int width = (int)reference["image_size"]![0]!, height = (int)reference["image_size"]![1]!;
            foreach (JProperty model in ((JObject)reference["stereo"]!).Properties())
            {
                LensModel lens = StereoReference.Model(model.Name);
                LensCamera left = Mono(pairs.Select(pair => pair.Left), width, height, lens), right = Mono(pairs.Select(pair => pair.Right), width, height, lens);
                foreach (JProperty kind in ((JObject)model.Value).Properties())
                {
                    LensModel? free = kind.Name == "fix_intrinsic" ? null : lens;
                    Assert.That(StereoCalibrator.TryCalibrate(pairs, left, right, free, true, out StereoCalibration? found, out string reason), Is.True, reason);
                    Compare(found!, kind.Value, window + " " + model.Name + " " + kind.Name);
                }
            }
        }

        private static LensCamera Mono(IEnumerable<BoardView> views, int width, int height, LensModel model)
        {
            Assert.That(CameraCalibrator.TryCalibrate(views.ToArray(), width, height, model, true, out CameraCalibration? found, out string reason), Is.True, reason);
            return found!.Camera;
        }

        private static void Compare(StereoCalibration found, JToken reference, string name)
        {
            double[] t = StereoReference.Numbers(reference["T"]!), r = StereoReference.Numbers(reference["rvec"]!);
            var axis = new Vector3D(r[0], r[1], r[2]);
            double translation = (found.Rig.LeftToRight.Position - new Vector3D(t[0], t[1], t[2])).Length;
            double rotation = StereoReference.AngleRad(found.Rig.LeftToRight.Rotation, Rotation3D.AboutAxis(axis, axis.Length));
            var epipolar = new EpipolarGeometry(found.Rig);
            (double meanSum, double rms) = epipolar.Errors(found.Pairs.SelectMany(pair => pair.Left.ImagePx.Zip(pair.Right.ImagePx)));
            StereoRectification rectified = StereoRectification.Of(found.Rig);

            // The reference scales its rectified pictures to show no border (alpha 0), ours keep the whole picture.
            double rows = RowDifferenceRms(found, rectified) * StereoReference.Numbers(reference["P1"]!)[0] / rectified.FocalPx;
            TriangulationCheck check = TriangulationCheck.Of(found);
            TestContext.Out.WriteLine(FormattableString.Invariant(
                $"{name}: rms {found.RmsPx:F6} against {(double)reference["rms"]!:F6} px, T off by {translation:E1}, R by {rotation:E1} rad, epipolar {meanSum:F5} against {(double)reference["epipolar"]!["opencv_sample_mean_sum_px"]!:F5}, rectified rows {rows:F5} against {(double)reference["rectified_vertical_disparity"]!["rms"]!:F5}"));
            Assert.That(found.RmsPx, Is.EqualTo((double)reference["rms"]!).Within(RmsTolerancePx), name);
            if (!name.EndsWith("fix_intrinsic", StringComparison.Ordinal))
                return;
            Assert.That(translation, Is.LessThanOrEqualTo(TranslationTolerance), name);
            Assert.That(rotation, Is.LessThanOrEqualTo(RotationToleranceRad), name);
            Assert.That(meanSum, Is.EqualTo((double)reference["epipolar"]!["opencv_sample_mean_sum_px"]!).Within(RmsTolerancePx), name);
            Assert.That(rms, Is.EqualTo((double)reference["epipolar"]!["rms_point_to_line_px"]!).Within(RmsTolerancePx), name);
            Assert.That(rows, Is.EqualTo((double)reference["rectified_vertical_disparity"]!["rms"]!).Within(0.005), name);
            Assert.That(check.EdgeRatioMean, Is.EqualTo((double)reference["triangulation"]!["edge_ratio_mean"]!).Within(1e-4), name);
            Assert.That(check.EdgeRatioDeviation, Is.EqualTo((double)reference["triangulation"]!["edge_ratio_std"]!).Within(1e-4), name);
            Assert.That(check.Behind, Is.Zero, name);
        }

        private static double RowDifferenceRms(StereoCalibration found, StereoRectification rectified)
        {
            double squares = 0;
            int count = 0;
            foreach ((Vector2D left, Vector2D right) in found.Pairs.SelectMany(pair => pair.Left.ImagePx.Zip(pair.Right.ImagePx)))
            {
                Vector2D q = default;
                Assert.That(rectified.TryMapLeft(left, out Vector2D p) && rectified.TryMapRight(right, out q), Is.True);
                squares += (p.Y - q.Y) * (p.Y - q.Y);
                count++;
            }

            return Math.Sqrt(squares / count);
        }
    }
}
