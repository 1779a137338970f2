using System;
using System.Text;
using LaserTracking.Geometry;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// A device's factory calibration, as recordings carry it (calibration.json), made concrete for the modes of a recording: the
    /// cameras of its infrared and colour pictures and how its sensors stand to each other. <see cref="KinectTransformation"/> maps with it.
    /// Immutable.
    /// </summary>
    public sealed class KinectCalibration
    {
        // Full sensors: depth 1024×1024, colour 4096×3072; other modes are parts of them, scaled.
        private const int DepthSide = 1024;
        private const int ColorFullWidth = 4096;
        private const int ColorFullHeight = 3072;
        private const double DefaultRadius = 1.7;
        private const double LeastRadius = 0.0001;

        private readonly Pose?[] _fromDepth;

        private KinectCalibration((LensCamera Camera, KinectLensCheck Check) infrared, (LensCamera Camera, KinectLensCheck Check) color, Pose?[] fromDepth)
        {
            Infrared = infrared.Camera;
            Color = color.Camera;
            InfraredCheck = infrared.Check;
            ColorCheck = color.Check;
            _fromDepth = fromDepth;
        }

        /// <summary>Depth pictures have it too.</summary>
        public LensCamera Infrared { get; }

        public LensCamera Color { get; }

        internal KinectLensCheck InfraredCheck { get; }

        internal KinectLensCheck ColorCheck { get; }

        /// <summary>X_color = R X_infrared + T, mm.</summary>
        public Pose InfraredToColorMm => _fromDepth[(int)KinectSensor.Color]!.Value;

        /// <summary>X_target = R X_source + T, mm; false when the file does not say where one of the two sits (motion sensors only).</summary>
        public bool TryGetPose(KinectSensor source, KinectSensor target, out Pose sourceToTargetMm)
        {
            sourceToTargetMm = Pose.Identity;
            if (!(_fromDepth[(int)source] is Pose from) || !(_fromDepth[(int)target] is Pose to))
                return false;
            sourceToTargetMm = source == target ? Pose.Identity : to * from.Inverse;
            return true;
        }

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
                Pose origin = Rig(depth).Inverse;
                var fromDepth = new Pose?[] { Pose.Identity, Rig(color) * origin, MotionSensor(root, "Gyro", origin), MotionSensor(root, "Accelerometer", origin) };
                calibration = new KinectCalibration(InfraredCamera(depth, depthMode, width, height), ColorCamera(color, colorWidth, colorHeight), fromDepth);
                reason = string.Empty;
                return true;
            }
            catch (Exception problem) when (problem is JsonException || problem is FormatException || problem is ArgumentException || problem is OverflowException || problem is InvalidCastException)
            {
                reason = "the device's calibration cannot be used (" + problem.Message.Split('\n')[0].TrimEnd('.', '\r') + ")";
                return false;
            }
        }

        private static (LensCamera Camera, KinectLensCheck Check) InfraredCamera(JToken camera, KinectDepthMode mode, int width, int height)
        {
            // The narrow modes show a part of the sensor, the binned ones every second pixel of it.
            bool isNarrow = mode == KinectDepthMode.NfovUnbinned || mode == KinectDepthMode.Nfov2x2Binned;
            double scale = mode == KinectDepthMode.Nfov2x2Binned || mode == KinectDepthMode.Wfov2x2Binned ? 0.5 : 1;
            return Lens(camera, DepthSide, DepthSide, 0, isNarrow ? 192 : 0, isNarrow ? 180 : 0, scale, width, height);
        }

        private static (LensCamera Camera, KinectLensCheck Check) ColorCamera(JToken camera, int width, int height)
        {
            // A sensor stated at 16:9 is the middle of the full one; so are pictures of that shape.
            int sensorHeight = Integer(camera, "SensorHeight"), sensorWidth = Integer(camera, "SensorWidth");
            if (sensorWidth <= 0 || sensorHeight <= 0 || (sensorWidth * 9L != sensorHeight * 16L && sensorWidth * 3L != sensorHeight * 4L))
                throw new FormatException("the colour sensor is neither of shape 4:3 nor 16:9");
            double stated = (double)ColorFullWidth * sensorHeight / sensorWidth, scale = width / (double)ColorFullWidth;
            double shown = height / scale;
            return Lens(camera, ColorFullWidth, stated, (ColorFullHeight - stated) / 2, 0, (ColorFullHeight - shown) / 2, scale, width, height);
        }

        private static (LensCamera Camera, KinectLensCheck Check) Lens(JToken camera, double sensorWidth, double sensorHeight, double addY, double cropX, double cropY, double scale, int width, int height)
        {
            JToken intrinsics = camera["Intrinsics"] ?? throw new FormatException("a camera has no intrinsics");
            string model = (string?)intrinsics["ModelType"] ?? "none";
            bool isRational6 = model == "CALIBRATION_LensDistortionModelRational6KT";
            if (!isRational6 && model != "CALIBRATION_LensDistortionModelBrownConrady")
                throw new FormatException("its lens model is " + model);

            // cx, cy, fx, fy as shares of the sensor; k1…k6; centre of distortion; p2, p1. The early model counts mixed terms once.
            double[] p = Numbers(intrinsics["ModelParameters"], 14);
            double radius = camera["MetricRadius"] is JValue value ? Convert.ToDouble(value.Value, System.Globalization.CultureInfo.InvariantCulture) : 0;
            radius = radius > LeastRadius ? radius : DefaultRadius;
            p[0] = (p[0] * sensorWidth - cropX) * scale - 0.5;
            p[1] = (p[1] * sensorHeight + addY - cropY) * scale - 0.5;
            p[2] *= sensorWidth * scale;
            p[3] *= sensorHeight * scale;
            int cross = isRational6 ? 1 : 2;
            var distortion = new BrownDistortion(p.AsSpan(4, 6), p[13], p[12], radius, new Vector2D(p[10], p[11]), cross);
            return (new LensCamera(new PinholeCamera(p[2], p[3], p[0], p[1], width, height), distortion), new KinectLensCheck(p, radius, cross));
        }

        private static Pose? MotionSensor(JObject root, string type, Pose origin)
        {
            if (root["CalibrationInformation"]?["InertialSensors"] is JArray sensors)
            {
                foreach (JToken sensor in sensors)
                {
                    if ((string?)sensor["SensorType"] == "CALIBRATION_InertialSensorType_" + type)
                        return Rig(sensor) * origin;
                }
            }

            return null;
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
