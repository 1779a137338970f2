using System;
using System.IO;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Factory calibrations against the genuine library's mode-specific cameras and mappings.</summary>
    [Category("Reference")]
    public sealed class KinectCalibrationReferenceTests
    {
        [Test]
        public void TryRead_EveryMode_GivesTheLibrarysIntrinsics()
        {
            var deviation = new Deviation("transform_reference.json, intrinsics of every mode");
            JObject reference = Reference();
            foreach (JProperty file in ((JObject)reference["all_modes"]!).Properties())
            {
                byte[] json = Calibration((string)reference["calibration_files"]![file.Name]!);
                foreach (JProperty mode in ((JObject)file.Value).Properties())
                {
                    bool isDepth = mode.Name.StartsWith("DEPTH_", StringComparison.Ordinal);
                    KinectDepthMode depthMode = isDepth ? KinectDepthModes.Parse(mode.Name["DEPTH_".Length..]) : KinectDepthMode.PassiveIr;
                    (int width, int height) = isDepth ? (1920, 1080) : ((int)mode.Value["resolution"]![0]!, (int)mode.Value["resolution"]![1]!);
                    Assert.That(KinectCalibration.TryRead(json, depthMode, width, height, out KinectCalibration? calibration, out string reason), Is.True, reason);
                    PinholeCamera camera = (isDepth ? calibration!.Infrared : calibration!.Color).Pinhole;
                    double[] found = { camera.CenterXPx, camera.CenterYPx, camera.FocalXPx, camera.FocalYPx };
                    for (int i = 0; i < 4; i++)
                        deviation.Add(Math.Abs(found[i] - (double)mode.Value["cx_cy_fx_fy"]![i]!));
                    Assert.That(new[] { camera.Width, camera.Height }, Is.EqualTo(new[] { (int)mode.Value["resolution"]![0]!, (int)mode.Value["resolution"]![1]! }));
                    Assert.That((isDepth ? calibration!.Infrared : calibration!.Color).Distortion.MaxRadius, Is.EqualTo((double)mode.Value["metric_radius"]!).Within(1e-6));
                }
            }

            deviation.AssertWithin(2e-3, "px");
        }

        [TestCase("")]
        [TestCase("{}")]
        [TestCase("[1]")]
        [TestCase("{\"CalibrationInformation\":{\"Cameras\":[{\"Location\":\"CALIBRATION_CameraLocationD0\"},{\"Location\":\"CALIBRATION_CameraLocationPV0\"}]}}")]
        public void TryRead_WhatIsNoCalibration_IsRefusedWithAReason(string json)
        {
            Assert.That(KinectCalibration.TryRead(System.Text.Encoding.UTF8.GetBytes(json), KinectDepthMode.PassiveIr, 1920, 1080, out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain("calibration"));
        }

        private static JObject Reference() => JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", "transform_reference.json")));

        private static byte[] Calibration(string file) => File.ReadAllBytes(TestFiles.Reference("k4a", file));
    }
}
