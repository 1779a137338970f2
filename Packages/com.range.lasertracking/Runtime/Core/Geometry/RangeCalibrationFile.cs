using System;
using System.Globalization;
using System.IO;
using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Reads and writes calibrations of kind "screen": {"v":1,"kind":"screen","image_size":[w,h],"H":[[…]],"screen_m":[w,h]} with an
    /// optional "hand_camera":{"image_size","K","R","T"} (T in mm, X_screen = R X_camera + T). Unknown fields are ignored.
    /// </summary>
    public static class RangeCalibrationFile
    {
        private const string Remedy = "calibrate again, or correct the field";

        /// <exception cref="InputException">Missing, not JSON, of another kind, or a field that is absent, not finite or impossible.</exception>
        public static RangeCalibration Read(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "this is a folder, not a calibration file", "name the .json file");
            if (!File.Exists(path))
                throw new InputException(path, "no such file", "'./range calibrate screen' makes one");
            try
            {
                return Parse(File.ReadAllText(path), path);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read (" + problem.Message.TrimEnd('.') + ")", "check its permissions");
            }
        }

        /// <param name="json">Content of the file.</param>
        /// <param name="name">As the user named it, for messages.</param>
        public static RangeCalibration Parse(string json, string name)
        {
            JObject root;
            try
            {
                root = JObject.Parse(json);
            }
            catch (JsonReaderException problem)
            {
                throw new InputException(name, FormattableString.Invariant($"not JSON at line {problem.LineNumber}, column {problem.LinePosition}"), Remedy);
            }

            string kind = (string?)(root["kind"] as JValue) ?? "none";
            if (kind != "screen")
                throw new InputException(name, "field kind is \"" + kind + "\", this needs a calibration of the screen", "name a file that './range calibrate screen' made");
            double[] size = Numbers(root["screen_m"], 2, name, "screen_m");
            int[] image = ImageSize(root["image_size"], name, "image_size");
            double[] h = Matrix(root["H"], name, "H");
            try
            {
                var homography = new Homography(h);
                if (!(Math.Abs(homography.Determinant) > 1e-15))
                    throw new ArgumentException("the matrix has no inverse");
                if (!(size[0] > 0 && size[1] > 0))
                    throw new InputException(name, "field screen_m: width and height must be above zero", Remedy);
                var screen = new ScreenGeometry(homography, new Vector2D(size[0], size[1]));
                CheckOutline(screen, name);
                return new RangeCalibration(screen, image[0], image[1], HandCamera(root["hand_camera"], name));
            }
            catch (ArgumentException problem)
            {
                throw new InputException(name, "field H: " + problem.Message, Remedy);
            }
        }

        public static void Write(RangeCalibration calibration, string path)
        {
            string temporary = path + ".part";
            File.WriteAllText(temporary, Format(calibration), new UTF8Encoding(false));
            File.Delete(path);
            File.Move(temporary, path);
        }

        /// <summary>The file's text, indented, with a final line feed.</summary>
        public static string Format(RangeCalibration calibration)
        {
            var root = new JObject
            {
                ["v"] = 1,
                ["kind"] = "screen",
                ["image_size"] = new JArray(calibration.ImageWidth, calibration.ImageHeight),
                ["H"] = Rows(calibration.Screen.ImageToScreen.ToArray()),
                ["screen_m"] = new JArray(calibration.Screen.ScreenSizeM.X, calibration.Screen.ScreenSizeM.Y),
            };
            if (calibration.HandCamera is HandCamera hand)
            {
                PinholeCamera camera = hand.Intrinsics;
                Pose pose = hand.PoseInScreenMm;
                Vector3D x = pose.TransformDirection(new Vector3D(1, 0, 0)), y = pose.TransformDirection(new Vector3D(0, 1, 0)), z = pose.TransformDirection(new Vector3D(0, 0, 1));
                root["hand_camera"] = new JObject
                {
                    ["image_size"] = new JArray(camera.Width, camera.Height),
                    ["K"] = Rows(new[] { camera.FocalXPx, 0, camera.CenterXPx, 0, camera.FocalYPx, camera.CenterYPx, 0, 0, 1 }),
                    ["R"] = Rows(new[] { x.X, y.X, z.X, x.Y, y.Y, z.Y, x.Z, y.Z, z.Z }),
                    ["T"] = new JArray(pose.Position.X, pose.Position.Y, pose.Position.Z),
                };
            }

            return root.ToString(Formatting.Indented).Replace("\r\n", "\n") + "\n";
        }

        /// <summary>A matrix with an inverse may still put a corner beyond the horizon, or the screen on to a line.</summary>
        private static void CheckOutline(ScreenGeometry screen, string name)
        {
            Vector2D size = screen.ScreenSizeM;
            var cornersM = new[] { new Vector2D(0, 0), new Vector2D(size.X, 0), size, new Vector2D(0, size.Y) };
            if (!HomographyEstimator.TryFit(screen.CornersPx, cornersM, out _, out string reason))
                throw new InputException(name, "field H gives no screen in the picture: " + reason, Remedy);
        }

        private static HandCamera? HandCamera(JToken? token, string name)
        {
            if (token == null || token.Type == JTokenType.Null)
                return null;
            int[] image = ImageSize(token["image_size"], name, "hand_camera.image_size");
            double[] k = Matrix(token["K"], name, "hand_camera.K"), r = Matrix(token["R"], name, "hand_camera.R"), t = Numbers(token["T"], 3, name, "hand_camera.T");
            if (!Rotation3D.TryFromMatrix(r, out Rotation3D rotation))
                throw new InputException(name, "field hand_camera.R is no rotation", Remedy);
            try
            {
                return new HandCamera(new PinholeCamera(k[0], k[4], k[2], k[5], image[0], image[1]), new Pose(new Vector3D(t[0], t[1], t[2]), rotation));
            }
            catch (ArgumentException problem)
            {
                throw new InputException(name, "field hand_camera: " + problem.Message, Remedy);
            }
        }

        private static double[] Matrix(JToken? token, string name, string field)
        {
            if (!(token is JArray rows) || rows.Count != 3)
                throw new InputException(name, "field " + field + " must be three rows of three numbers", Remedy);
            var result = new double[9];
            for (int row = 0; row < 3; row++)
                Numbers(rows[row], 3, name, field).CopyTo(result, row * 3);
            return result;
        }

        private static double[] Numbers(JToken? token, int count, string name, string field)
        {
            if (!(token is JArray list) || list.Count != count)
                throw new InputException(name, FormattableString.Invariant($"field {field} must be {count} numbers"), Remedy);
            var result = new double[count];
            for (int i = 0; i < count; i++)
            {
                bool isNumber = list[i].Type == JTokenType.Float || list[i].Type == JTokenType.Integer;
                result[i] = isNumber ? Convert.ToDouble(((JValue)list[i]).Value, CultureInfo.InvariantCulture) : double.NaN;
                if (double.IsNaN(result[i]) || double.IsInfinity(result[i]))
                    throw new InputException(name, FormattableString.Invariant($"field {field}, element {i + 1}, is not a finite number"), Remedy);
            }

            return result;
        }

        private static int[] ImageSize(JToken? token, string name, string field)
        {
            double[] size = Numbers(token, 2, name, field);
            if (!(size[0] >= 1 && size[1] >= 1 && size[0] <= 65536 && size[1] <= 65536))
                throw new InputException(name, "field " + field + " must be a width and a height in pixels", Remedy);
            return new[] { (int)size[0], (int)size[1] };
        }

        private static JArray Rows(double[] m) => new JArray(new JArray(m[0], m[1], m[2]), new JArray(m[3], m[4], m[5]), new JArray(m[6], m[7], m[8]));
    }
}
