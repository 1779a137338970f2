using System;
using System.CommandLine;
using System.IO;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate screen|verify: from measured points; the automatic calibration is a later release's work.</summary>
    internal static class CalibrateCommand
    {
        private const double DefaultLimitMm = 5;

        public static Command Create() => new("calibrate", "Fits the screen's place in the image from measured points, and checks it.") { Screen(), Verify() };

        private static Command Screen()
        {
            var points = new Option<string?>("--points") { Description = "JSON file with image_px, screen_m and, better, verify." };
            var corners = new Option<string[]>("--corners") { Description = "Instead: the screen's corners in the image, x,y four times, top-left first, clockwise.", AllowMultipleArgumentsPerToken = true };
            var size = new Option<string>("--size") { Description = "Width and height of the projected picture in metres: 3.73x2.26.", Required = true };
            var imageSize = new Option<string>("--image-size") { Description = "Width and height of the image in pixels.", DefaultValueFactory = _ => "1280x720" };
            var output = new Option<string>("--out") { Description = "The calibration to write.", DefaultValueFactory = _ => "screen.json" };
            var limit = new Option<double>("--limit") { Description = "Largest held-out error that passes, mm.", DefaultValueFactory = _ => DefaultLimitMm };
            var command = new Command("screen", "Fits image pixels to screen metres.") { points, corners, size, imageSize, output, limit };
            command.SetAction(parsed =>
            {
                Vector2D sizeM = ScreenPoints.Pair(parsed.GetValue(size)!, 'x', "--size");
                if (!(sizeM.X > 0 && sizeM.Y > 0))
                    throw new InputException("--size", "width and height must be above zero", "write it as 3.73x2.26");
                string? file = parsed.GetValue(points);
                string[] given = parsed.GetValue(corners) ?? Array.Empty<string>();
                if (file == null && given.Length == 0)
                    throw new InputException("calibrate screen", "no points given", "use --points FILE or --corners");
                ScreenPoints measured = file != null ? ScreenPoints.Read(file) : ScreenPoints.FromCorners(given, sizeM);
                Vector2D pixels = measured.ImageSize is { } own ? new Vector2D(own[0], own[1]) : ScreenPoints.Pair(parsed.GetValue(imageSize)!, 'x', "--image-size");
                if (!HomographyEstimator.TryFit(measured.ImagePx, measured.ScreenM, out Homography homography, out string reason))
                    throw new InputException(file ?? "--corners", reason, "measure these points again");
                var calibration = new RangeCalibration(new ScreenGeometry(homography, sizeM), (int)pixels.X, (int)pixels.Y, null);
                return Report(calibration, measured, parsed.GetValue(limit), parsed.GetValue(output));
            });
            return command;
        }

        private static Command Verify()
        {
            var file = new Argument<string>("CALIBRATION");
            var points = new Option<string>("--points") { Description = "JSON file with image_px and screen_m of points that the fit did not use.", Required = true };
            var limit = new Option<double>("--limit") { Description = "Largest error that passes, mm.", DefaultValueFactory = _ => DefaultLimitMm };
            var command = new Command("verify", "Errors of a calibration on points not used in the fit; exit 1 over the limit.") { file, points, limit };
            command.SetAction(parsed =>
            {
                RangeCalibration calibration = RangeCalibrationFile.Read(parsed.GetValue(file)!);
                ScreenPoints measured = ScreenPoints.Read(parsed.GetValue(points)!);
                var heldOut = measured with { VerifyImagePx = measured.ImagePx, VerifyScreenM = measured.ScreenM };
                return Report(calibration, heldOut, parsed.GetValue(limit), null);
            });
            return command;
        }

        private static int Report(RangeCalibration calibration, ScreenPoints measured, double limitMm, string? output)
        {
            Homography toScreen = calibration.Screen.ImageToScreen, toImage = toScreen.Inverse;
            var result = new JObject();
            if (output != null)
            {
                result["rms_px"] = PointErrors.Of(toImage, measured.ScreenM, measured.ImagePx, 1).Rms;
                result["rms_mm"] = PointErrors.Of(toScreen, measured.ImagePx, measured.ScreenM, 1000).Rms;
            }

            PointErrors mm = PointErrors.Of(toScreen, measured.VerifyImagePx, measured.VerifyScreenM, 1000);
            PointErrors px = PointErrors.Of(toImage, measured.VerifyScreenM, measured.VerifyImagePx, 1);
            result["verify"] = new JObject { ["n"] = mm.Count, ["median_mm"] = mm.Median, ["p95_mm"] = mm.P95, ["max_mm"] = mm.Max, ["median_px"] = px.Median, ["max_px"] = px.Max };
            Console.WriteLine(result.ToString());
            if (mm.Count > 0 && !(mm.Max <= limitMm))
            {
                Console.Error.WriteLine(FormattableString.Invariant($"range: the held-out error reaches {mm.Max:F2} mm, over the limit of {limitMm} mm; nothing was written"));
                return ExitCodes.CheckFailed;
            }

            if (output == null)
                return ExitCodes.Done;
            if (mm.Count == 0)
                Console.Error.WriteLine("range: no held-out points: the fit proves nothing about itself; fire check shots or give \"verify\" points");
            JObject file = JObject.Parse(RangeCalibrationFile.Format(calibration));
            file.Merge(result);
            string temporary = output + ".part";
            File.WriteAllText(temporary, file.ToString() + "\n");
            File.Move(temporary, output, true);
            return ExitCodes.Done;
        }
    }
}
