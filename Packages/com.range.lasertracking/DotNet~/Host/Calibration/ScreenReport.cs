using System;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Patterns;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>What is said of a calibration of the screen: as JSON, and in sentences on standard error.</summary>
    internal static class ScreenReport
    {
        public static JObject OfPattern(ScreenCalibration found)
        {
            PointErrors fitPx = found.Errors(false, inMm: false), fitMm = found.Errors(false, inMm: true);
            var result = new JObject
            {
                ["accepted"] = found.IsAccepted,
                ["refusals"] = new JArray(found.Refusals),
                ["notes"] = new JArray(found.Notes),
                ["frames"] = found.View.Frames,
                ["mirrored"] = found.View.IsMirrored,
                ["proof"] = "held-out points of the pattern",
                ["lens_found"] = found.IsLensFound,
                ["fit_points"] = fitPx.Count,
                ["left_out"] = found.Points.Count(p => p.IsLeftOut),
                ["rms_px"] = fitPx.Rms,
                ["rms_mm"] = fitMm.Rms,
                ["verify"] = Errors(found.Errors(true, inMm: true), found.Errors(true, inMm: false)),
            };
            result["regions"] = new JArray(found.Regions.Select(Region));
            return result;
        }

        public static void Say(ScreenCalibration found)
        {
            foreach (string note in found.Notes)
                Console.Error.WriteLine("range: " + note);
            if (found.View.IsMirrored)
                Console.Error.WriteLine("range: the picture is mirrored: right for a camera behind the screen");
            foreach (string refusal in found.Refusals)
                Console.Error.WriteLine("range: refused: " + refusal);
            if (!found.IsAccepted)
                Console.Error.WriteLine("range: nothing was written");
        }

        /// <summary>
        /// Corners outside the picture are possible, a screen that is nowhere in it is a mistake. So is one that is mirrored, unless the
        /// user says that the camera stands behind it: every shot would score on the wrong side.
        /// </summary>
        public static void CheckPlace(RangeCalibration calibration, string source, bool isMirrored)
        {
            Vector2D center = calibration.Screen.ToImagePx(calibration.Screen.ScreenSizeM * 0.5);
            if (!(center.X >= 0 && center.Y >= 0 && center.X < calibration.ImageWidth && center.Y < calibration.ImageHeight))
                throw new InputException(source, FormattableString.Invariant($"the middle of the screen lies at {center.X:F0},{center.Y:F0}, outside the image of {calibration.ImageWidth}x{calibration.ImageHeight}"), "check the points, and give the image's size with --image-size");
            Vector2D[] corners = calibration.Screen.CornersPx;
            bool looksMirrored = Vector2D.Cross(corners[1] - corners[0], corners[3] - corners[0]) < 0;
            if (looksMirrored != isMirrored)
                throw new InputException(source, looksMirrored ? "the picture is mirrored: the points run the wrong way round" : "the picture is not mirrored, --mirrored says that it is",
                    looksMirrored ? "give them clockwise from the top left, or add --mirrored when the camera stands behind the screen" : "leave --mirrored out, or turn the points' order round");
        }

        /// <summary>A point may lie a little beside the screen; by more than half a screen it is no point of this screen in metres.</summary>
        public static void CheckOnScreen(Vector2D[] placesM, Vector2D sizeM, string field, string source)
        {
            int i = Array.FindIndex(placesM, place => !(Math.Abs(place.X - 0.5 * sizeM.X) <= sizeM.X && Math.Abs(place.Y - 0.5 * sizeM.Y) <= sizeM.Y));
            if (i >= 0)
                throw new InputException(source, FormattableString.Invariant($"field {field}, point {i + 1} lies at {placesM[i].X:G6},{placesM[i].Y:G6}, far outside the screen of {sizeM.X:G6}x{sizeM.Y:G6} m"), "give metres from the screen's top left corner, and the screen's own --size");
        }

        /// <summary>Points that lie beside the picture cannot have been measured there, if its size is sure and not just the usual one: refused then, else said.</summary>
        public static void CheckInside(Vector2D[] px, string field, RangeCalibration calibration, string source, bool isSure)
        {
            if (ScreenPoints.FirstOutside(px, calibration.ImageWidth, calibration.ImageHeight) is not string outside)
                return;
            if (isSure)
                throw new InputException(source, $"field {field}, {outside}", "correct the point, or the image's size");
            Console.Error.WriteLine($"range: {source}: field {field}, {outside}: check the point, and the size given with --image-size");
        }

        private static JObject Region(ScreenRegion region)
        {
            var result = new JObject
            {
                ["name"] = region.Name, ["projected"] = region.Projected, ["measured"] = region.Measured, ["covered"] = region.Covered, ["unclear"] = region.Unclear,
                ["out_of_picture"] = region.OutOfPicture, ["blur_px"] = region.BlurPx, ["sigma_mm"] = region.SigmaMm,
            };
            result["verify"] = Errors(region.HeldOutMm, region.HeldOutPx);
            return result;
        }

        public static JObject Errors(PointErrors mm, PointErrors px) => mm.Count == 0
            ? new JObject { ["n"] = 0 }
            : new JObject { ["n"] = mm.Count, ["median_mm"] = mm.Median, ["p95_mm"] = mm.P95, ["max_mm"] = mm.Max, ["median_px"] = px.Median, ["p95_px"] = px.P95, ["max_px"] = px.Max };
    }
}
