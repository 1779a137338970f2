using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Reads and writes calibrations of kind "screen": {"v":1,"kind":"screen","image_size":[w,h],"H":[[…]],"screen_m":[w,h]}. Optional:
    /// "K" and "dist", camera 0 with its lens (then H maps pixels free of distortion); "focal_known", false where K is nominal;
    /// "proof", "none" where no held-out point has checked it; "corners_cov_px2", 8×8, how far the corners may be off; "corners_lens_cov", 10×10, the same jointly with k1 and k2; "residuals_mm", what its check points said; "hand_camera":{"image_size","K","R","T"} (T in mm, X_screen = R X_camera + T). Unknown fields are ignored.
    /// </summary>
    public static class RangeCalibrationFile
    {
        /// <summary>What the field "proof" says of a calibration that no held-out point has checked.</summary>
        public const string NoProof = "none";

        private const string Remedy = CalibrationJson.Remedy;
        private const int MaxResiduals = 200;

        /// <exception cref="InputException">Missing, not JSON, of another kind or a newer version, or a field that is absent, not finite or impossible.</exception>
        public static RangeCalibration Read(string path) => Parse(CalibrationJson.ReadFile(path), path);

        /// <param name="json">Content of the file.</param>
        /// <param name="name">As the user named it, for messages.</param>
        public static RangeCalibration Parse(string json, string name) => Parse(CalibrationJson.Parse(json, name), name);

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
            ScreenGeometry screen = calibration.Screen;
            var root = new JObject
            {
                ["v"] = CalibrationJson.Version,
                ["kind"] = "screen",
                ["image_size"] = new JArray(calibration.ImageWidth, calibration.ImageHeight),
                ["H"] = CalibrationJson.Rows(screen.ImageToScreen.ToArray(), 3),
                ["screen_m"] = new JArray(screen.ScreenSizeM.X, screen.ScreenSizeM.Y),
            };
            if (screen.Camera is LensCamera camera)
            {
                JObject lens = LensCameraJson.Format(camera);
                root["K"] = lens["K"];
                root["dist"] = lens["dist"];
            }

            if (screen.Camera != null && !screen.IsFocalLengthKnown)
                root["focal_known"] = false;
            if (screen.Uncertainty is HomographyUncertainty uncertainty)
            {
                double[,] joint = uncertainty.Of(ScreenGeometry.CornersOf(screen.ScreenSizeM));
                root["corners_cov_px2"] = CalibrationJson.Rows(Corner(joint, 8), 8);
                if (uncertainty.LensCoefficients > 0)
                    root["corners_lens_cov"] = CalibrationJson.Rows(Corner(joint, joint.GetLength(0)), joint.GetLength(0));
            }

            if (calibration.IsUnverified)
                root["proof"] = NoProof;
            if (calibration.Residuals.Count > 0)
                root["residuals_mm"] = FormatResiduals(calibration.Residuals);
            if (calibration.HandCamera is HandCamera hand)
            {
                JObject content = LensCameraJson.Format(hand.Intrinsics);
                content["R"] = CalibrationJson.Rows(hand.PoseInScreenMm.Rotation.ToMatrix(), 3);
                content["T"] = new JArray(hand.PoseInScreenMm.Position.X, hand.PoseInScreenMm.Position.Y, hand.PoseInScreenMm.Position.Z);
                root["hand_camera"] = content;
            }

            return root.ToString(Formatting.Indented).Replace("\r\n", "\n") + "\n";
        }

        /// <summary>Of many points some, evenly: enough to be looked at.</summary>
        private static JArray FormatResiduals(IReadOnlyList<ScreenResidual> residuals)
        {
            var rows = new JArray();
            int step = (residuals.Count + MaxResiduals - 1) / MaxResiduals;
            for (int i = 0; i < residuals.Count; i += step)
                rows.Add(new JArray(Math.Round(residuals[i].ScreenM.X, 4), Math.Round(residuals[i].ScreenM.Y, 4), Math.Round(residuals[i].OffMm.X, 3), Math.Round(residuals[i].OffMm.Y, 3)));
            return rows;
        }

        private static ScreenResidual[] Residuals(JToken? token, string name)
        {
            if (IsAbsent(token))
                return Array.Empty<ScreenResidual>();
            if (!(token is JArray rows) || rows.Count > 4 * MaxResiduals)
                throw new InputException(name, "field residuals_mm is no list of points", Remedy);
            var residuals = new ScreenResidual[rows.Count];
            for (int i = 0; i < residuals.Length; i++)
            {
                double[] n = CalibrationJson.Numbers(rows[i], 4, name, "residuals_mm");
                residuals[i] = new ScreenResidual(new Vector2D(n[0], n[1]), new Vector2D(n[2], n[3]));
            }

            return residuals;
        }

        /// <summary>The first rows and columns, row by row.</summary>
        private static double[] Corner(double[,] matrix, int side)
        {
            var flat = new double[side * side];
            for (int i = 0; i < flat.Length; i++)
                flat[i] = matrix[i / side, i % side];
            return flat;
        }

        private static RangeCalibration Parse(JObject root, string name)
        {
            CalibrationJson.CheckKind(root, name, "screen", "'./range calibrate screen'");
            double[] size = CalibrationJson.Numbers(root["screen_m"], 2, name, "screen_m");
            int[] image = CalibrationJson.ImageSize(root["image_size"], name, "image_size");
            double[] h = CalibrationJson.Matrix(root["H"], 3, name, "H");
            if (!(size[0] > 0 && size[1] > 0))
                throw new InputException(name, "field screen_m: width and height must be above zero", Remedy);
            LensCamera? camera = IsAbsent(root["K"]) && IsAbsent(root["dist"]) ? null : LensCameraJson.Parse(root, name, string.Empty);
            ScreenGeometry screen;
            try
            {
                var homography = new Homography(h);
                if (!(Math.Abs(homography.Determinant) > 1e-15))
                    throw new ArgumentException("the matrix has no inverse");
                screen = new ScreenGeometry(homography, new Vector2D(size[0], size[1]), camera);
            }
            catch (ArgumentException problem)
            {
                throw new InputException(name, "field H: " + problem.Message, Remedy);
            }

            CheckOutline(screen, name);
            bool isJoint = camera != null && !IsAbsent(root["corners_lens_cov"]);
            HomographyUncertainty? uncertainty = isJoint ? Uncertainty(root, "corners_lens_cov", 8 + PlaneLens.Coefficients, screen, name)
                : IsAbsent(root["corners_cov_px2"]) ? null : Uncertainty(root, "corners_cov_px2", 8, screen, name);

            // Files from before "focal_known" say of a nominal focal length that the lens was found.
            bool isNominal = isJoint || IsTrue(root["lens_found"]) || (root["focal_known"]?.Type == JTokenType.Boolean && !IsTrue(root["focal_known"]));
            screen = new ScreenGeometry(screen.ImageToScreen, screen.ScreenSizeM, camera, uncertainty, !isNominal);
            bool isUnverified = (root["proof"] as JValue)?.Value is string proof && proof == NoProof;
            return new RangeCalibration(screen, image[0], image[1], HandCamera(root["hand_camera"], name), isUnverified, Residuals(root["residuals_mm"], name));
        }

        private static bool IsTrue(JToken? token) => token?.Type == JTokenType.Boolean && (bool)token;

        private static bool IsAbsent(JToken? token) => token == null || token.Type == JTokenType.Null;

        /// <summary>A matrix with an inverse may still put a corner beyond the horizon or the lens, or the screen on to a line.</summary>
        private static void CheckOutline(ScreenGeometry screen, string name)
        {
            if (!HomographyEstimator.TryFit(screen.CornersPx, ScreenGeometry.CornersOf(screen.ScreenSizeM), out _, out string reason))
                throw new InputException(name, "field H gives no screen in the picture: " + reason, Remedy);
        }

        private static HomographyUncertainty Uncertainty(JObject root, string field, int side, ScreenGeometry screen, string name)
        {
            var covariance = new double[side, side];
            Buffer.BlockCopy(CalibrationJson.Matrix(root[field], side, name, field), 0, covariance, 0, sizeof(double) * side * side);
            if (!HomographyUncertainty.TryFromAnchors(screen.ImageToScreen.Inverse, ScreenGeometry.CornersOf(screen.ScreenSizeM), covariance, out HomographyUncertainty? uncertainty, out string reason))
                throw new InputException(name, "field " + field + ": " + reason, Remedy);
            return uncertainty!;
        }

        private static HandCamera? HandCamera(JToken? token, string name)
        {
            if (IsAbsent(token))
                return null;
            PinholeCamera camera = LensCameraJson.ParsePinhole(token!, name, "hand_camera.");
            double[] r = CalibrationJson.Matrix(token!["R"], 3, name, "hand_camera.R"), t = CalibrationJson.Numbers(token["T"], 3, name, "hand_camera.T");
            if (!Rotation3D.TryFromMatrix(r, out Rotation3D rotation))
                throw new InputException(name, "field hand_camera.R is no rotation", Remedy);
            return new HandCamera(camera, new Pose(new Vector3D(t[0], t[1], t[2]), rotation));
        }
    }
}
