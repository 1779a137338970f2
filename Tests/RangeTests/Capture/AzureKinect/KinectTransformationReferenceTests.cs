using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Mapping between the sensors against the genuine library, which counts in single precision.</summary>
    [Category("Reference")]
    public sealed class KinectTransformationReferenceTests
    {
        private const double ToleranceMm = 0.01;
        private const double TolerancePx = 0.01;

        [Test]
        public void KinectTransformation_EveryMapping_AgreesWithTheLibrary()
        {
            JObject reference = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", "transform_reference.json")));
            Deviation mm = new("transform_reference.json, points"), px = new("transform_reference.json, pixels"), valid = new("transform_reference.json, valid");
            foreach (JToken combo in reference["combos"]!)
            {
                string name = (string)combo["calibration"]! + " " + combo["calibration_t"]!["depth_mode"] + " " + combo["calibration_t"]!["color_resolution"];
                KinectTransformation transformation = Transformation(reference, combo);
                foreach (string kind in new[] { "2d_to_3d", "3d_to_2d", "3d_to_3d", "2d_to_2d" })
                foreach (JToken row in combo[kind]!["rows"]!)
                {
                    bool hasFlag = kind != "3d_to_3d", isValid = Map(transformation, kind, row, out double[] result);
                    int first = kind switch { "2d_to_3d" => 6, "3d_to_2d" => 6, "3d_to_3d" => 5, _ => 6 };
                    bool expected = !hasFlag || (int)row[5]! == 1;
                    valid.Add(isValid == expected ? 0 : 1);
                    if (isValid != expected)
                        TestContext.Out.WriteLine(name + " " + kind + " " + row.ToString(Newtonsoft.Json.Formatting.None));
                    if (!expected || !isValid)
                        continue;
                    double squares = 0;
                    for (int i = 0; i < result.Length; i++)
                        squares += Math.Pow(result[i] - (double)row[first + i]!, 2);
                    (result.Length == 3 ? mm : px).Add(Math.Sqrt(squares));
                }
            }

            mm.AssertWithin(ToleranceMm, "mm");
            px.AssertWithin(TolerancePx, "px");
            valid.AssertWithin(0, "(1: differs)");
        }

        private static bool Map(KinectTransformation transformation, string kind, JToken row, out double[] result)
        {
            KinectSensor source = Sensor(row[0]!), target = Sensor(row[1]!);
            double a = (double)row[2]!, b = (double)row[3]!, c = (double)row[4]!;
            Vector3D point;
            Vector2D pixel;
            bool isValid;
            switch (kind)
            {
                case "2d_to_3d":
                    isValid = transformation.TryTo3D(source, new Vector2D(a, b), c, target, out point);
                    result = [point.X, point.Y, point.Z];
                    return isValid;
                case "3d_to_3d":
                    isValid = transformation.TryTo3D(source, new Vector3D(a, b, c), target, out point);
                    result = [point.X, point.Y, point.Z];
                    return isValid;
                case "3d_to_2d":
                    isValid = transformation.TryTo2D(source, new Vector3D(a, b, c), target, out pixel);
                    break;
                default:
                    isValid = transformation.TryTo2D(source, new Vector2D(a, b), c, target, out pixel);
                    break;
            }

            result = [pixel.X, pixel.Y];
            return isValid;
        }

        private static KinectSensor Sensor(JToken name) => (string)name! switch
        {
            "DEPTH" => KinectSensor.Depth,
            "COLOR" => KinectSensor.Color,
            "GYRO" => KinectSensor.Gyro,
            "ACCEL" => KinectSensor.Accelerometer,
            _ => throw new InvalidDataException("no such sensor: " + name),
        };

        private static KinectTransformation Transformation(JObject reference, JToken combo)
        {
            byte[] json = File.ReadAllBytes(TestFiles.Reference("k4a", (string)reference["calibration_files"]![(string)combo["calibration"]!]!));
            var size = (JArray)combo["calibration_t"]!["color_camera"]!["resolution"]!;
            KinectDepthMode mode = KinectDepthModes.Parse((string)combo["calibration_t"]!["depth_mode"]!);
            Assert.That(KinectCalibration.TryRead(json, mode, (int)size[0], (int)size[1], out KinectCalibration? calibration, out string reason), Is.True, reason);
            return new KinectTransformation(calibration!);
        }
    }
}
