using System;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// A camera with its lens in calibration files: "image_size":[w,h], "K":[[…]], "dist":[k1,k2,p1,p2,k3(,k4,k5,k6)], OpenCV's order.
    /// </summary>
    public static class LensCameraJson
    {
        /// <summary>Reads a calibration of kind "camera".</summary>
        /// <exception cref="InputException">Missing, not JSON, of another kind or a newer version, or a field that is absent or impossible.</exception>
        public static LensCamera ReadFile(string path)
        {
            JObject root = CalibrationJson.ReadFile(path);
            CalibrationJson.CheckKind(root, path, "camera", "'./range calibrate board'");
            return Parse(root, path, string.Empty);
        }

        /// <summary>Reads the three fields of an object.</summary>
        /// <param name="camera">Holds image_size, K and dist.</param>
        /// <param name="name">The file as the user named it, for messages.</param>
        /// <param name="prefix">What stands before the fields' names in messages: "camera.".</param>
        /// <exception cref="InputException">A field that is absent, not finite or impossible.</exception>
        public static LensCamera Parse(JToken camera, string name, string prefix)
        {
            PinholeCamera pinhole = ParsePinhole(camera, name, prefix);
            int count = camera["dist"] is JArray list && list.Count == 8 ? 8 : 5;
            return new LensCamera(pinhole, BrownDistortion.FromOpenCv(CalibrationJson.Numbers(camera["dist"], count, name, prefix + "dist")));
        }

        /// <summary>Reads image_size and K alone.</summary>
        /// <exception cref="InputException">A field that is absent, not finite or impossible.</exception>
        public static PinholeCamera ParsePinhole(JToken camera, string name, string prefix)
        {
            int[] size = CalibrationJson.ImageSize(camera["image_size"], name, prefix + "image_size");
            double[] k = CalibrationJson.Matrix(camera["K"], 3, name, prefix + "K");
            if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
                throw new InputException(name, "field " + prefix + "K must have the form [[fx,0,cx],[0,fy,cy],[0,0,1]]", CalibrationJson.Remedy);
            try
            {
                return new PinholeCamera(k[0], k[4], k[2], k[5], size[0], size[1]);
            }
            catch (ArgumentException problem)
            {
                throw new InputException(name, "field " + prefix + "K: " + problem.Message, CalibrationJson.Remedy);
            }
        }

        /// <summary>The three fields.</summary>
        public static JObject Format(LensCamera camera)
        {
            JObject result = Format(camera.Pinhole);
            result["dist"] = new JArray(camera.Distortion.ToOpenCv());
            return result;
        }

        /// <summary>image_size and K alone.</summary>
        public static JObject Format(PinholeCamera camera) => new JObject
        {
            ["image_size"] = new JArray(camera.Width, camera.Height),
            ["K"] = CalibrationJson.Rows(new[] { camera.FocalXPx, 0, camera.CenterXPx, 0, camera.FocalYPx, camera.CenterYPx, 0, 0, 1 }, 3),
        };
    }
}
