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
            JObject reference = Reference();
            foreach (JProperty file in ((JObject)reference["all_modes"]!).Properties())
            {
                byte[] json = Calibration((string)reference["calibration_files"]![file.Name]!);
                foreach (JProperty mode in ((JObject)file.Value).Properties())
                {
                    bool isDepth = mode.Name.StartsWith("DEPTH_", StringComparison.Ordinal);
                    KinectDepthMode depthMode = isDepth ? KinectDepthModes.Parse(mode.Name["DEPTH_".Length..]) : KinectDepthMode.PassiveIr;
                    (int width, int height) = isDepth ? (1920, 1080) : ((int)mode.Value["resolution"]![0]!, (int)mode.Value["resolution"]![1]!);
                    if (file.Name.Contains("rational6kt"))
                    {
                        Assert.That(KinectCalibration.TryRead(json, depthMode, width, height, out _, out string refusal), Is.False);
                        Assert.That(refusal, Does.Contain("lens model"));
                        continue;
                    }

                    Assert.That(KinectCalibration.TryRead(json, depthMode, width, height, out KinectCalibration? calibration, out string reason), Is.True, reason);
                    PinholeCamera camera = (isDepth ? calibration!.Infrared : calibration!.Color).Pinhole;
                    double[] found = { camera.CenterXPx, camera.CenterYPx, camera.FocalXPx, camera.FocalYPx };
                    for (int i = 0; i < 4; i++)
                        Assert.That(found[i], Is.EqualTo((double)mode.Value["cx_cy_fx_fy"]![i]!).Within(2e-3), file.Name + " " + mode.Name + " " + i);
                }
            }
        }

        [Test]
        public void TryRead_DepthPixelToColorPixel_AgreesWithTheLibrary()
        {
            JObject reference = Reference();
            int points = 0;
            foreach (JToken combo in reference["combos"]!)
            {
                string name = (string)combo["calibration"]!, resolution = (string)combo["calibration_t"]!["color_resolution"]!;
                if (name.Contains("rational6kt"))
                    continue;
                var size = (JArray)combo["calibration_t"]!["color_camera"]!["resolution"]!;
                KinectDepthMode depthMode = KinectDepthModes.Parse((string)combo["calibration_t"]!["depth_mode"]!);
                Assert.That(KinectCalibration.TryRead(Calibration((string)reference["calibration_files"]![name]!), depthMode, (int)size[0], (int)size[1], out KinectCalibration? calibration, out string reason), Is.True, reason);
                foreach (JToken row in combo["2d_to_2d"]!["rows"]!)
                {
                    if ((string)row[0]! != "DEPTH" || (string)row[1]! != "COLOR" || (int)row[5]! != 1)
                        continue;
                    double depth = (double)row[4]!;
                    Assert.That(calibration!.Infrared.TryUnproject(new Vector2D((double)row[2]!, (double)row[3]!), out Vector2D ray), Is.True);
                    Vector3D p = calibration.InfraredToColorMm.TransformPoint(new Vector3D(ray.X * depth, ray.Y * depth, depth));
                    Assert.That(calibration.Color.TryProject(new Vector2D(p.X / p.Z, p.Y / p.Z), out Vector2D pixel), Is.True);
                    Assert.That((pixel - new Vector2D((double)row[6]!, (double)row[7]!)).Length, Is.LessThan(0.01), name + " " + resolution + " " + row);
                    points++;
                }
            }

            Assert.That(points, Is.GreaterThan(100));
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
