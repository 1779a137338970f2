using System;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Point clouds and depth seen from the colour camera against the genuine library.</summary>
    [Category("Reference")]
    public sealed class KinectDepthViewReferenceTests
    {
        [Test]
        public void KinectDepthView_WholePictures_AgreeWithTheLibrary()
        {
            Deviation cloud = new("transform_reference.json, point cloud samples"), view = new("transform_reference.json, depth to colour samples"), count = new("transform_reference.json, depth to colour, pixels with depth");
            foreach (JToken item in JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", "transform_reference.json")))["image_transforms"]!["items"]!)
            {
                KinectCalibration calibration = Read(item, out ushort[] depth);
                var kinect = new KinectDepthView(calibration);
                int width = calibration.Infrared.Pinhole.Width;
                var points = new short[3 * depth.Length];
                kinect.PointCloud(depth, points);
                foreach (JToken sample in item["point_cloud"]!["samples"]!)
                {
                    int at = (int)sample[1]! * width + (int)sample[0]!;
                    cloud.Add(Enumerable.Range(0, 3).Max(i => Math.Abs(points[3 * at + i] - (int)sample[3 + i]!)));
                }

                bool isSame = KinectReference.Hash(MemoryMarshal.AsBytes(points.AsSpan()).ToArray()) == (string)item["point_cloud"]!["sha256"]!;
                TestContext.Out.WriteLine((string)item["file"]! + " capture " + item["capture"] + ": point cloud " + (isSame ? "equal byte for byte" : "differs somewhere by rounding"));

                PinholeCamera color = calibration.Color.Pinhole;
                var picture = new ushort[color.Width * color.Height];
                kinect.ToColor(depth, picture);
                foreach (JToken sample in item["depth_to_color"]!["samples"]!)
                    view.Add(Math.Abs(picture[(int)sample[1]! * color.Width + (int)sample[0]!] - (int)sample[2]!));
                int expected = (int)item["depth_to_color"]!["nonzero_pixels"]!, found = picture.Count(d => d > 0);
                TestContext.Out.WriteLine(FormattableString.Invariant($"pixels with depth: {found} against {expected}"));
                count.Add(Math.Abs(found - expected) / (double)expected);
            }

            cloud.AssertWithin(0, "mm");
            view.AssertWithin(1, "mm");
            count.AssertWithin(1e-3, "of all");
        }

        [Test]
        public void KinectDepthSearch_ColorPixelsOfARecording_FindTheDepthPixelTheyCameFrom()
        {
            JToken item = JObject.Parse(File.ReadAllText(TestFiles.Reference("k4a", "transform_reference.json")))["image_transforms"]!["items"]!.First!;
            KinectCalibration calibration = Read(item, out ushort[] depth);
            var search = new KinectDepthSearch(calibration);
            var transformation = new KinectTransformation(calibration);
            int width = calibration.Infrared.Pinhole.Width, looked = 0, found = 0;
            double worst = 0;
            for (int y = 40; y < calibration.Infrared.Pinhole.Height - 40; y += 37)
            for (int x = 40; x < width - 40; x += 41)
            {
                // Beside an edge the nearer thing may hide the place from the other camera.
                int d = depth[y * width + x];
                bool isSmooth = d > 0 && Enumerable.Range(0, 25).All(i => Math.Abs(depth[(y + 4 * (i / 5 - 2)) * width + x + 4 * (i % 5 - 2)] - d) < 0.03 * d);
                if (!isSmooth || !transformation.TryTo2D(KinectSensor.Depth, new Vector2D(x, y), d, KinectSensor.Color, out Vector2D color))
                    continue;
                looked++;
                if (!search.TryFind(color, depth, out Vector2D back) || (back - new Vector2D(x, y)).Length > 1)
                    continue;
                found++;
                worst = Math.Max(worst, (back - new Vector2D(x, y)).Length);
            }

            TestContext.Out.WriteLine(FormattableString.Invariant($"{found} of {looked} found, worst {worst:G3} px"));
            Assert.That(looked, Is.GreaterThan(50));
            Assert.That(found, Is.GreaterThanOrEqualTo(0.98 * looked));
        }

        private static KinectCalibration Read(JToken item, out ushort[] depth)
        {
            using KinectRecording recording = KinectRecording.Open(TestFiles.Reference("k4a", (string)item["file"]!));
            var capture = new KinectCapture();
            for (int i = 0; i <= (int)item["capture"]!; i++)
                Assert.That(recording.TryReadNext(capture), Is.True);
            depth = new ushort[capture.Depth.SizeBytes / 2];
            Assert.That(recording.TryReadPayload(capture.Depth, MemoryMarshal.AsBytes(depth.AsSpan())), Is.True);
            Assert.That(recording.TryReadCalibration(out byte[] json), Is.True);
            KinectRecordConfiguration configuration = recording.Configuration;
            Assert.That(KinectCalibration.TryRead(json, configuration.DepthMode, configuration.ColorWidth, configuration.ColorHeight, out KinectCalibration? calibration, out string reason), Is.True, reason);
            return calibration!;
        }
    }
}
