using System;
using System.Globalization;
using System.IO;
using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Points of the screen as seen in the image: {"image_px":[[x,y],…],"screen_m":[[x,y],…],"verify":{…same two…}}.</summary>
    internal sealed record ScreenPoints(Vector2D[] ImagePx, Vector2D[] ScreenM, Vector2D[] VerifyImagePx, Vector2D[] VerifyScreenM, (int Width, int Height)? ImageSize)
    {
        public static ScreenPoints Read(string path)
        {
            if (!File.Exists(path))
                throw new InputException(path, Directory.Exists(path) ? "this is a folder" : "no such file", "give the file of measured points");
            JObject root = CalibrationJson.ReadFile(path);
            CalibrationJson.CheckVersion(root, path);
            Vector2D[] image = Points(root, path, "image_px", "image_px", true), screen = Points(root, path, "screen_m", "screen_m", true);
            JToken? verify = root["verify"];
            if (verify is JArray pairs)
                verify = pairs.FirstOrDefault();
            if (verify is { Type: not (JTokenType.Object or JTokenType.Null) })
                throw new InputException(path, "field verify is no object", "give {\"image_px\":[[x,y],…],\"screen_m\":[[x,y],…]}");
            Vector2D[] verifyImage = Points(verify, path, "image_px", "verify.image_px", false), verifyScreen = Points(verify, path, "screen_m", "verify.screen_m", false);
            if (image.Length != screen.Length || verifyImage.Length != verifyScreen.Length)
                throw new InputException(path, "image_px and screen_m differ in length", "every point needs its partner");
            (int, int)? size = root["image_size"] is { Type: not JTokenType.Null } given ? PixelSize(given, path) : null;
            return new ScreenPoints(image, screen, verifyImage, verifyScreen, size);
        }

        /// <summary>All points as those to check with, none as those of a fit.</summary>
        public ScreenPoints AsVerify() => this with { ImagePx = [], ScreenM = [], VerifyImagePx = ImagePx, VerifyScreenM = ScreenM };

        /// <summary>Four corners "x,y" of the image, top-left first, clockwise.</summary>
        public static ScreenPoints FromCorners(string[] corners, Vector2D sizeM)
        {
            if (corners.Length != 4)
                throw new InputException("--corners", $"{corners.Length} corners given", "give four: top-left x,y, then clockwise");
            var screen = new[] { default, new Vector2D(sizeM.X, 0), sizeM, new Vector2D(0, sizeM.Y) };
            return new ScreenPoints(corners.Select(c => Pair(c, ',', "--corners")).ToArray(), screen, Array.Empty<Vector2D>(), Array.Empty<Vector2D>(), null);
        }

        /// <summary>What to say of the first point that lies beside the picture, where nothing can have been seen; null when all lie in it.</summary>
        public static string? FirstOutside(Vector2D[] px, int width, int height)
        {
            int i = Array.FindIndex(px, p => !(p.X >= -0.5 && p.Y >= -0.5 && p.X <= width - 0.5 && p.Y <= height - 0.5));
            return i < 0 ? null : FormattableString.Invariant($"point {i + 1} lies at {px[i].X:G6},{px[i].Y:G6}, outside the image of {width}x{height}");
        }

        /// <summary>Two numbers with a separator, in invariant culture.</summary>
        public static Vector2D Pair(string text, char separator, string option)
        {
            string[] parts = text.Split(separator);
            if (parts.Length == 2 && double.TryParse(parts[0], NumberStyles.Float, CultureInfo.InvariantCulture, out double x) &&
                double.TryParse(parts[1], NumberStyles.Float, CultureInfo.InvariantCulture, out double y) && new Vector2D(x, y).IsFinite)
                return new Vector2D(x, y);
            throw new InputException(option, $"\"{text}\" is not two numbers with a '{separator}' between", $"write it as 3.5{separator}2");
        }

        /// <summary>"1280x720".</summary>
        public static (int Width, int Height) PixelSize(string text, string option = "--image-size")
        {
            string[] parts = text.Split('x');
            return parts.Length == 2 && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int width) && int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int height) && IsPixelSize(width, height)
                ? (width, height)
                : throw new InputException(option, $"\"{text}\" is no size in pixels", "write it as 1280x720");
        }

        private static (int Width, int Height) PixelSize(JToken size, string path) =>
            size is JArray { Count: 2 } list && list.All(n => n.Type == JTokenType.Integer) && IsPixelSize((double)list[0], (double)list[1])
                ? ((int)list[0], (int)list[1])
                : throw new InputException(path, "field image_size is no size in pixels", "write it as [1280,720]");

        private static bool IsPixelSize(double width, double height) => width >= 1 && height >= 1 && width <= 65536 && height <= 65536;

        private static Vector2D[] Points(JToken? parent, string path, string field, string shown, bool required)
        {
            if (parent?[field] is not JArray list)
                return required ? throw new InputException(path, "field " + shown + " is missing", "give a list of [x,y]") : Array.Empty<Vector2D>();
            var points = new Vector2D[list.Count];
            for (int i = 0; i < points.Length; i++)
            {
                if (list[i] is not JArray { Count: 2 } pair || pair.Any(n => n.Type is not (JTokenType.Float or JTokenType.Integer)) || !new Vector2D((double)pair[0], (double)pair[1]).IsFinite)
                    throw new InputException(path, $"field {shown}, point {i + 1}, is not two finite numbers", "correct the point");
                points[i] = new Vector2D((double)pair[0], (double)pair[1]);
            }

            return points;
        }
    }
}
