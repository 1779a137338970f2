using System.Linq;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>What a history needs of a calibration file of any kind.</summary>
    internal sealed record CalibrationRecord(string File, string Kind, string Date, string ImageSize, double? RmsPx, int? Views, double? HeldOut)
    {
        /// <summary>Of px or mm: what is larger is no calibration.</summary>
        private const double MostError = 1e6;

        private static readonly string[] Kinds = { "camera", "stereo", "screen" };

        /// <summary>Unit of the held-out error: mm on the screen, px else.</summary>
        public string HeldOutUnit => Kind == "screen" ? "mm" : "px";

        /// <exception cref="InputException">No calibration, or one of a newer version.</exception>
        public static CalibrationRecord Read(string path) => Of(CalibrationJson.ReadFile(path), path);

        /// <param name="root">The calibration.</param>
        /// <param name="name">For messages.</param>
        public static CalibrationRecord Of(JObject root, string name)
        {
            string kind = Text(root["kind"]) ?? "none";
            if (!Kinds.Contains(kind))
                throw new InputException(name, $"field kind is \"{kind}\", which is no calibration", "name what './range calibrate' made");
            CalibrationJson.CheckKind(root, name, kind, "'./range calibrate'");
            double? heldOut = kind == "screen" ? Number(Child(root, "verify", "p95_mm"), name, "verify.p95_mm") : Number(Child(root, "held_out", "rms_px"), name, "held_out.rms_px");
            int? views = root["views"] is JArray list ? list.Count : root["per_view_rms_px"] is JArray errors ? errors.Count : null;
            return new CalibrationRecord(System.IO.Path.GetFileName(name), kind, Day(root["date"], name), Sizes(root), Number(root["rms_px"], name, "rms_px"), views, heldOut);
        }

        /// <summary>
        /// Whether the other has the smaller error: the held-out one where both have it, else the fit's; unknown is no better. For a
        /// screen only proof counts: a fit through four corners meets them exactly.
        /// </summary>
        public bool IsWorseThan(CalibrationRecord other) => Kind == "screen"
            ? other.HeldOut is double proven && !(HeldOut <= proven)
            : HeldOut is double mine && other.HeldOut is double theirs ? mine > theirs : RmsPx is double fit && other.RmsPx is double otherFit && fit > otherFit;

        /// <summary>The error it is judged by, in words.</summary>
        public string Error(bool byHeldOut) => byHeldOut
            ? System.FormattableString.Invariant($"{HeldOut:F4} {HeldOutUnit} on held-out views")
            : System.FormattableString.Invariant($"{RmsPx:F4} px");

        private static JToken? Child(JObject root, string parent, string field) => (root[parent] as JObject)?[field];

        /// <summary>An error that is given must be one: a negative one would be the best for ever.</summary>
        private static double? Number(JToken? token, string name, string field)
        {
            if (token == null || token.Type == JTokenType.Null)
                return null;
            return token.Type is JTokenType.Float or JTokenType.Integer && (double)token is >= 0 and < MostError and double number
                ? number
                : throw new InputException(name, $"field {field} is no error of a calibration", "calibrate again, or correct the field");
        }

        /// <summary>Empty when there is none.</summary>
        private static string Day(JToken? token, string name)
        {
            if (token == null || token.Type == JTokenType.Null)
                return string.Empty;
            return Text(token) is string text && System.DateOnly.TryParseExact(text, "yyyy-MM-dd", out _)
                ? text
                : throw new InputException(name, "field date is no date", "write it as 2026-11-22");
        }

        private static string? Text(JToken? token) => token?.Type switch
        {
            JTokenType.String => (string?)token,
            JTokenType.Date => ((System.DateTime)token).ToString("yyyy-MM-dd", System.Globalization.CultureInfo.InvariantCulture),
            _ => null,
        };

        private static string Sizes(JObject root) => string.Join(" ", new[] { root["image_size"], Child(root, "left", "image_size"), Child(root, "right", "image_size") }
            .OfType<JArray>().Select(size => string.Join("×", size)));
    }
}
