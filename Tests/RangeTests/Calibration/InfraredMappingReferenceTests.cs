using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Calibration
{
    /// <summary>Infrared laid on colour with the corners that a real Azure Kinect saw of one board in both pictures.</summary>
    [Category("Reference")]
    public sealed class InfraredMappingReferenceTests
    {
        private const double LimitPx = 0.5;
        private const double JudgedWidthPx = 1920;

        [Test]
        public void OnPlane_PosesFromOneBoard_MapsWithinHalfAPixel()
        {
            Sight sight = Sight.Load();
            Assert.That(PlanarPoseEstimator.TryEstimate(sight.ColorView, sight.Color, out PlanarPose? color, out string reason), Is.True, reason);
            Assert.That(PlanarPoseEstimator.TryEstimate(sight.InfraredView, sight.Infrared, out PlanarPose? infrared, out reason), Is.True, reason);
            Rotation3D rotation = color!.Pose.Rotation * infrared!.Pose.Rotation.Inverse;
            var pose = new Pose(color.Pose.Position - rotation * infrared.Pose.Position, rotation);
            double[] t = StereoReference.Numbers(sight.Reference["ir_to_color"]!["T_mm"]!);
            Vector3D normal = color.Pose.TransformDirection(new Vector3D(0, 0, 1));
            InfraredMapping mapping = InfraredMapping.OnPlane(sight.Infrared, sight.Color, pose, new Plane3D(normal, color.Pose.Position));
            double rms = sight.RmsPx(mapping, _ => true);
            TestContext.Out.WriteLine(FormattableString.Invariant($"poses: colour {color.RmsPx:F4} px, infrared {infrared.RmsPx:F4} px; mapping rms {rms:F4} px at 1920"));
            Assert.That(color.RmsPx, Is.EqualTo((double)sight.Reference["color"]!["reproj_rms_px"]!).Within(1e-3));
            Assert.That(infrared.RmsPx, Is.EqualTo((double)sight.Reference["ir"]!["reproj_rms_px"]!).Within(1e-3));
            Assert.That((pose.Position - new Vector3D(t[0], t[1], t[2])).Length, Is.LessThanOrEqualTo(0.1));
            Assert.That(rms, Is.LessThanOrEqualTo(LimitPx));
        }

        [Test]
        public void TryFitPlane_EveryOtherPoint_MapsTheRestWithinHalfAPixel()
        {
            Sight sight = Sight.Load();
            double all = sight.RmsPx(sight.Fit(sight.Infrared, sight.Color, _ => true), _ => true);
            double rest = sight.RmsPx(sight.Fit(sight.Infrared, sight.Color, i => i % 2 == 0), i => i % 2 == 1);
            double ignored = sight.RmsPx(sight.Fit(WithoutLens(sight.Infrared), WithoutLens(sight.Color), _ => true), _ => true);
            TestContext.Out.WriteLine(FormattableString.Invariant($"mapping rms at 1920: all points {all:F4} px, the half not used {rest:F4} px, lenses ignored {ignored:F4} px"));
            Assert.That(all, Is.EqualTo((double)sight.Reference["planar_homography_ir_to_color"]!["undistorted_rms_color_px"]! * JudgedWidthPx / sight.Color.Pinhole.Width).Within(0.01));
            Assert.That(rest, Is.LessThanOrEqualTo(LimitPx));
            Assert.That(ignored, Is.GreaterThan(10 * rest));
        }

        private static LensCamera WithoutLens(LensCamera camera) => new(camera.Pinhole, BrownDistortion.None);

        private sealed class Sight
        {
            private readonly List<(Vector2D Infrared, Vector2D Color)> _common = new();

            private Sight(JObject reference, LensCamera infrared, LensCamera color, BoardView infraredView, BoardView colorView)
            {
                Reference = reference;
                Infrared = infrared;
                Color = color;
                InfraredView = infraredView;
                ColorView = colorView;
                for (int i = 0; i < infraredView.BoardMm.Length; i++)
                {
                    int partner = Array.IndexOf(colorView.BoardMm, infraredView.BoardMm[i]);
                    if (partner >= 0)
                        _common.Add((infraredView.ImagePx[i], colorView.ImagePx[partner]));
                }
            }

            public JObject Reference { get; }

            public LensCamera Infrared { get; }

            public LensCamera Color { get; }

            public BoardView InfraredView { get; }

            public BoardView ColorView { get; }

            public static Sight Load()
            {
                var reference = (JObject)StereoReference.Load("stereo", "azure_kinect_charuco", "reference.json")["registration"]!;
                return new Sight(reference, Camera(reference["ir"]!), Camera(reference["color"]!), View(reference["ir"]!), View(reference["color"]!));
            }

            public InfraredMapping Fit(LensCamera infrared, LensCamera color, Func<int, bool> isUsed)
            {
                (Vector2D Infrared, Vector2D Color)[] used = _common.Where((_, i) => isUsed(i)).ToArray();
                Assert.That(InfraredMapping.TryFitPlane(infrared, color, used.Select(p => p.Infrared).ToArray(), used.Select(p => p.Color).ToArray(), out InfraredMapping? mapping, out string reason), Is.True, reason);
                return mapping!;
            }

            public double RmsPx(InfraredMapping mapping, Func<int, bool> isJudged)
            {
                var squares = new List<double>();
                for (int i = 0; i < _common.Count; i++)
                {
                    if (!isJudged(i))
                        continue;
                    Assert.That(mapping.TryMap(_common[i].Infrared, out Vector2D mapped), Is.True);
                    squares.Add((mapped - _common[i].Color).LengthSquared);
                }

                return Math.Sqrt(squares.Average()) * JudgedWidthPx / Color.Pinhole.Width;
            }

            private static LensCamera Camera(JToken camera) =>
                StereoReference.Camera(camera["K"]!, camera["dist"]!, (int)camera["image_size"]![0]!, (int)camera["image_size"]![1]!);

            private static BoardView View(JToken camera) => StereoReference.View((string)camera["image"]!, StereoReference.Points(camera["board_xy_mm"]!), StereoReference.Points(camera["px"]!));
        }
    }
}
