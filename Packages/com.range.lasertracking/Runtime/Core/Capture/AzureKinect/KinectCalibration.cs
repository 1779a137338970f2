using System;
using System.Text;
using LaserTracking.Geometry;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// A device's factory calibration, as recordings carry it (calibration.json), made concrete for the modes of a recording: the
    /// cameras of its infrared and colour pictures and how they stand to each other. Immutable.
    /// </summary>
    public sealed class KinectCalibration
    {
        // Full sensors: depth 1024×1024, colour 4096×3072; other modes are parts of them, scaled.
        private const int DepthSide = 1024;
        private const int ColorFullWidth = 4096;
        private const int ColorFullHeight = 3072;
        private const double DefaultRadius = 1.7;

        private KinectCalibration(LensCamera infrared, LensCamera color, Pose infraredToColorMm)
        {
            Infrared = infrared;
            Color = color;
            InfraredToColorMm = infraredToColorMm;
        }

        /// <summary>Depth pictures have it too.</summary>
        public LensCamera Infrared { get; }

        public LensCamera Color { get; }

        /// <summary>X_color = R X_infrared + T, mm.</summary>
        public Pose InfraredToColorMm { get; }

        /// <param name="json">The attachment's bytes; a zero at the end is accepted.</param>
        /// <param name="depthMode">Mode of the infrared pictures.</param>
        /// <param name="colorWidth">Width of the colour pictures.</param>
        /// <param name="colorHeight">Their height.</param>
        /// <param name="calibration">Valid only when true is returned.</param>
        /// <param name="reason">Why there is none, one line; empty on success.</param>
        public static bool TryRead(byte[] json, KinectDepthMode depthMode, int colorWidth, int colorHeight, out KinectCalibration? calibration, out string reason)
        {
            calibration = null;
            try
            {
                JObject root = JObject.Parse(Encoding.UTF8.GetString(json).TrimStart('\uFEFF').TrimEnd('\0'));
                JToken depth = Camera(root, "CALIBRATION_CameraLocationD0"), color = Camera(root, "CALIBRATION_CameraLocationPV0");
                (int width, int height) = KinectDepthModes.SizeOf(depthMode);
                if (width == 0 || colorWidth <= 0 || colorHeight <= 0)
                    throw new FormatException("there are no infrared or no colour pictures");
                Pose fromDepth = Rig(depth), fromColor = Rig(color);
                calibration = new KinectCalibration(InfraredCamera(depth, depthMode, width, height), ColorCamera(color, colorWidth, colorHeight), fromColor * fromDepth.Inverse);
                reason = string.Empty;
                return true;
            }
            catch (Exception problem) when (problem is JsonException || problem is FormatException || problem is ArgumentException || problem is OverflowException || problem is InvalidCastException)
            {
                reason = "the device's calibration cannot be used (" + problem.Message.Split('\n')[0].TrimEnd('.', '\r') + ")";
                return false;
            }
        }

        private static LensCamera InfraredCamera(JToken camera, KinectDepthMode mode, int width, int height)
        {
            // The narrow modes show a part of the sensor, the binned ones every second pixel of it.
            bool isNarrow = mode == KinectDepthMode.NfovUnbinned || mode == KinectDepthMode.Nfov2x2Binned;
            double scale = mode == KinectDepthMode.Nfov2x2Binned || mode == KinectDepthMode.Wfov2x2Binned ? 0.5 : 1;
            return Lens(camera, DepthSide, DepthSide, 0, isNarrow ? 192 : 0, isNarrow ? 180 : 0, scale, width, height);
        }

        private static LensCamera ColorCamera(JToken camera, int width, int height)
        {
            // A sensor stated at 16:9 is the middle of the full one; so are pictures of that shape.
            int sensorHeight = Integer(camera, "SensorHeight"), sensorWidth = Integer(camera, "SensorWidth");
            if (sensorWidth <= 0 || sensorHeight <= 0)
                throw new FormatException("the colour sensor has no size");
            double stated = (double)ColorFullWidth * sensorHeight / sensorWidth, scale = width / (double)ColorFullWidth;
            double shown = height / scale;
            return Lens(camera, ColorFullWidth, stated, (ColorFullHeight - stated) / 2, 0, (ColorFullHeight - shown) / 2, scale, width, height);
        }

        private static LensCamera Lens(JToken camera, double sensorWidth, double sensorHeight, double addY, double cropX, double cropY, double scale, int width, int height)
        {
            JToken intrinsics = camera["Intrinsics"] ?? throw new FormatException("a camera has no intrinsics");
            string model = (string?)intrinsics["ModelType"] ?? "none";
            if (model != "CALIBRATION_LensDistortionModelBrownConrady")
                throw new FormatException("its lens model is " + model);

            // cx, cy, fx, fy as shares of the sensor; k1…k6; centre of distortion; p2, p1.
            double[] p = Numbers(intrinsics["ModelParameters"], 14);
            if (p[10] != 0 || p[11] != 0)
                throw new FormatException("its centre of distortion is not the principal point");
            double radius = camera["MetricRadius"] is JValue value ? Convert.ToDouble(value.Value, System.Globalization.CultureInfo.InvariantCulture) : 0;
            var pinhole = new PinholeCamera(p[2] * sensorWidth * scale, p[3] * sensorHeight * scale,
                (p[0] * sensorWidth - cropX) * scale - 0.5, (p[1] * sensorHeight + addY - cropY) * scale - 0.5, width, height);
            return new LensCamera(pinhole, new BrownDistortion(p.AsSpan(4, 6), p[13], p[12], radius > 0 ? radius : DefaultRadius));
        }

        private static Pose Rig(JToken camera)
        {
            double[] t = Numbers(camera["Rt"]?["Translation"], 3);
            if (!Rotation3D.TryFromMatrix(Numbers(camera["Rt"]?["Rotation"], 9), out Rotation3D rotation))
                throw new FormatException("a camera's rotation is none");
            return new Pose(new Vector3D(t[0], t[1], t[2]) * 1000, rotation);
        }

        private static JToken Camera(JObject root, string location)
        {
            if (root["CalibrationInformation"]?["Cameras"] is JArray cameras)
            {
                foreach (JToken camera in cameras)
                {
                    if ((string?)camera["Location"] == location)
                        return camera;
                }
            }

            throw new FormatException("it has no camera " + location);
        }

        private static int Integer(JToken camera, string name) => (int?)camera[name] ?? 0;

        private static double[] Numbers(JToken? token, int count)
        {
            if (!(token is JArray list) || list.Count < count)
                throw new FormatException("a list of " + count + " numbers is missing");
            var result = new double[count];
            for (int i = 0; i < count; i++)
            {
                result[i] = (double?)list[i] ?? double.NaN;
                if (double.IsNaN(result[i]) || double.IsInfinity(result[i]))
                    throw new FormatException("a number is not finite");
            }

            return result;
        }
    }
}
