using System;
using System.Text;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    public sealed class KinectTransformationTests
    {
        private const int Width = 320;
        private const int Height = 288;

        // One camera as the device writes it: shares of the sensor, k1…k6, centre of distortion, p2, p1.
        private const string Json = "{\"CalibrationInformation\":{\"Cameras\":[" +
            "{\"Location\":\"CALIBRATION_CameraLocationD0\",\"SensorWidth\":1024,\"SensorHeight\":1024,\"MetricRadius\":1.74," +
            "\"Intrinsics\":{\"ModelType\":\"CALIBRATION_LensDistortionModelBrownConrady\",\"ModelParameters\":[0.502,0.5018,0.4928,0.4929,0.5825,0.0061,-0.0013,0.9256,0.1257,-0.0065,0,0,-2e-5,-0.00013]}," +
            "\"Rt\":{\"Rotation\":[1,0,0,0,1,0,0,0,1],\"Translation\":[0,0,0]}}," +
            "{\"Location\":\"CALIBRATION_CameraLocationPV0\",\"SensorWidth\":4096,\"SensorHeight\":3072,\"MetricRadius\":0," +
            "\"Intrinsics\":{\"ModelType\":\"CALIBRATION_LensDistortionModelRational6KT\",\"ModelParameters\":[0.5064,0.5013,0.4732,0.6306,0.6688,-2.7474,1.5317,0.5454,-2.5779,1.464,0.0011,0.001,-8.6e-5,0.00083]}," +
            "\"Rt\":{\"Rotation\":[1,0,0,0,0.9945219,0.1045285,0,-0.1045285,0.9945219],\"Translation\":[-0.032,-0.002,0.004]}}]}}";

        [Test]
        public void KinectTransformation_ToSpaceAndBack_IsTheSamePixel()
        {
            var transformation = new KinectTransformation(Calibration());
            foreach (var pixel in new[] { new Vector2D(20, 30), new Vector2D(160, 144), new Vector2D(301.5, 250.25) })
            {
                Assert.That(transformation.TryTo3D(KinectSensor.Depth, pixel, 1500, KinectSensor.Color, out Vector3D point), Is.True);
                Assert.That(transformation.TryTo2D(KinectSensor.Color, point, KinectSensor.Depth, out Vector2D back), Is.True);
                Assert.That((back - pixel).Length, Is.LessThan(1e-8));
                Assert.That(transformation.TryTo2D(KinectSensor.Depth, pixel, 1500, KinectSensor.Color, out Vector2D color), Is.True);
                Assert.That(transformation.CameraOf(KinectSensor.Color).TryProject(point, out Vector2D same) && (same - color).Length < 1e-9, Is.True);
            }
        }

        [Test]
        public void KinectTransformation_WhatHasNoAnswer_IsRefused()
        {
            var transformation = new KinectTransformation(Calibration());
            var middle = new Vector2D(160, 144);
            Assert.That(transformation.TryTo3D(KinectSensor.Depth, middle, 0, KinectSensor.Depth, out _), Is.False);
            Assert.That(transformation.TryTo3D(KinectSensor.Depth, middle, double.NaN, KinectSensor.Depth, out _), Is.False);
            Assert.That(transformation.TryTo3D(KinectSensor.Depth, new Vector2D(double.NaN, 3), 900, KinectSensor.Depth, out _), Is.False);
            Assert.That(transformation.TryTo3D(KinectSensor.Depth, new Vector2D(90000, 3), 900, KinectSensor.Depth, out _), Is.False);
            Assert.That(transformation.TryTo2D(KinectSensor.Depth, new Vector3D(0, 0, -500), KinectSensor.Depth, out _), Is.False);
            Assert.That(transformation.TryTo3D(KinectSensor.Depth, new Vector3D(1, 2, 3), KinectSensor.Gyro, out _), Is.False);
            Assert.That(() => transformation.CameraOf(KinectSensor.Gyro), Throws.ArgumentException);
        }

        [Test]
        public void KinectDepthView_WallSeenFromTheColorCamera_HasTheWallsDepthThere()
        {
            KinectCalibration calibration = Calibration();
            ushort[] depth = Scene(0, out _), color = new ushort[1280 * 720];
            var view = new KinectDepthView(calibration);
            view.ToColor(depth, color);
            var transformation = new KinectTransformation(calibration);
            int filled = 0;
            for (int y = 100; y < 620; y += 40)
            for (int x = 300; x < 980; x += 40)
            {
                int found = color[y * 1280 + x];
                if (found == 0)
                    continue;
                filled++;
                Assert.That(transformation.TryTo3D(KinectSensor.Color, new Vector2D(x, y), found, KinectSensor.Depth, out Vector3D point), Is.True);
                Assert.That(point.Z, Is.EqualTo(2000).Within(2));
            }

            Assert.That(filled, Is.GreaterThan(150));
            Assert.That(Allocation.Of(() => view.ToColor(depth, color)), Is.Zero);
        }

        [Test]
        public void KinectDepthView_PointCloud_LeavesOutWhatWasNotMeasured()
        {
            ushort[] depth = Scene(0, out _);
            depth[5 * Width + 7] = 0;
            var points = new short[3 * depth.Length];
            new KinectDepthView(Calibration()).PointCloud(depth, points);
            Assert.That(new[] { points[3 * (5 * Width + 7)], points[3 * (5 * Width + 7) + 2] }, Is.EqualTo(new short[] { 0, 0 }));
            Assert.That(points[3 * (100 * Width + 100) + 2], Is.EqualTo(2000));
            Assert.That(() => new KinectDepthView(Calibration()).PointCloud(new ushort[7], points), Throws.ArgumentException);
        }

        [Test]
        public void KinectDepthSearch_BehindAPost_MeetsThePostNotTheWall()
        {
            KinectCalibration calibration = Calibration();
            ushort[] depth = Scene(1, out Vector2D post);
            var transformation = new KinectTransformation(calibration);
            var search = new KinectDepthSearch(calibration);
            Assert.That(transformation.TryTo2D(KinectSensor.Depth, post, 900, KinectSensor.Color, out Vector2D color), Is.True);
            Assert.That(search.TryFind(color, depth, out Vector2D found), Is.True);
            Assert.That((found - post).Length, Is.LessThan(0.6));
            Assert.That(search.TryFind(color, new ushort[depth.Length], out _), Is.False);
            Assert.That(search.TryFind(new Vector2D(double.NaN, 1), depth, out _), Is.False);
        }

        [Test]
        public void KinectCalibration_BrokenBytes_AreRefusedOrRead()
        {
            var random = new Random(9);
            for (int i = 0; i < 500; i++)
            {
                byte[] bytes = Encoding.UTF8.GetBytes(Json);
                for (int change = random.Next(1, 5); change > 0; change--)
                    bytes[random.Next(bytes.Length)] = (byte)random.Next(256);
                Array.Resize(ref bytes, i % 5 == 0 ? random.Next(bytes.Length) : bytes.Length);
                bool isRead = KinectCalibration.TryRead(bytes, KinectDepthMode.Nfov2x2Binned, 1280, 720, out KinectCalibration? calibration, out string reason);
                Assert.That(isRead ? calibration != null && reason.Length == 0 : reason.Length > 0 && !reason.Contains('\n'), Is.True);
            }
        }

        [Test]
        public void KinectCalibration_ColorSensorOfAnotherShape_IsRefused()
        {
            byte[] json = Encoding.UTF8.GetBytes(Json.Replace("\"SensorHeight\":3072", "\"SensorHeight\":3000"));
            Assert.That(KinectCalibration.TryRead(json, KinectDepthMode.Nfov2x2Binned, 1280, 720, out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain("4:3"));
        }

        private static KinectCalibration Calibration()
        {
            Assert.That(KinectCalibration.TryRead(Encoding.UTF8.GetBytes(Json), KinectDepthMode.Nfov2x2Binned, 1280, 720, out KinectCalibration? calibration, out string reason), Is.True, reason);
            return calibration!;
        }

        /// <summary>A wall at 2 m and, if wanted, an upright post at 0.9 m.</summary>
        private static ushort[] Scene(int posts, out Vector2D post)
        {
            post = new Vector2D(150, 140);
            var depth = new ushort[Width * Height];
            for (int i = 0; i < depth.Length; i++)
                depth[i] = (ushort)(posts > 0 && Math.Abs(i % Width - post.X) <= 6 ? 900 : 2000);
            return depth;
        }
    }
}
