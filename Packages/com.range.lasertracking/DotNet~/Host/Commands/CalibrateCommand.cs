using System;
using System.CommandLine;
using System.Text;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Sessions;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate screen|verify: from measured points; the automatic calibration is a later release's work.</summary>
    internal static class CalibrateCommand
    {
        private const double DefaultLimitMm = 5;
        private const double MinimumScreenM = 0.05;
        private const double MaximumScreenM = 100;

        public static Command Create() => new("calibrate", "Determines the screen, a camera or two cameras, and checks them.") { Screen(), Verify(), CalibrateBoardCommand.Create(), CalibrateStereoCommand.Create(), CalibrateHistoryCommand.Create(), CalibrateSimulateCommand.Create() };

        private static Command Screen()
        {
            var points = new Option<string?>("--points") { HelpName = "FILE", Description = "JSON file with image_px, screen_m and, better, verify." };
            var corners = new Option<string[]>("--corners") { HelpName = "X,Y", Description = "Instead: the screen's corners in the image, x,y four times, top-left first, clockwise.", AllowMultipleArgumentsPerToken = true };
            var size = new Option<string>("--size") { HelpName = "WxH", Description = "Width and height of the projected picture in metres: 3.73x2.26.", Required = true };
            var imageSize = new Option<string>("--image-size") { HelpName = "WxH", Description = "Width and height of the image in pixels.", DefaultValueFactory = _ => "1280x720" };
            var output = new Option<string>("--out") { HelpName = "FILE", Description = "The calibration to write.", DefaultValueFactory = _ => "screen.json" };
            var limit = new Option<double>("--limit") { HelpName = "MM", Description = "Largest held-out error that passes, mm.", DefaultValueFactory = _ => DefaultLimitMm };
            var command = new Command("screen", "Fits image pixels to screen metres.") { points, corners, size, imageSize, output, limit };
            command.SetAction(parsed =>
            {
                Vector2D sizeM = ScreenPoints.Pair(parsed.GetValue(size)!, 'x', "--size");
                if (!(Math.Min(sizeM.X, sizeM.Y) >= MinimumScreenM && Math.Max(sizeM.X, sizeM.Y) <= MaximumScreenM))
                    throw new InputException("--size", $"\"{parsed.GetValue(size)}\" is no screen of 0.05 to 100 metres", "write it as 3.73x2.26");
                string? file = parsed.GetValue(points);
                string[] given = parsed.GetValue(corners) ?? Array.Empty<string>();
                if (file == null && given.Length == 0)
                    throw new InputException("calibrate screen", "no points given", "use --points FILE or --corners");
                ResultFile.CheckNotRead(parsed.GetValue(output), file);
                ScreenPoints measured = file != null ? ScreenPoints.Read(file) : ScreenPoints.FromCorners(given, sizeM);
                (int width, int height) = measured.ImageSize ?? ScreenPoints.PixelSize(parsed.GetValue(imageSize)!);
                if (!HomographyEstimator.TryFit(measured.ImagePx, measured.ScreenM, out Homography homography, out string reason))
                    throw new InputException(file ?? "--corners", reason, "measure these points again");
                var calibration = new RangeCalibration(new ScreenGeometry(homography, sizeM), width, height, null);
                CheckPlace(calibration, file ?? "--corners");
                return Report(calibration, measured, parsed.GetValue(limit), parsed.GetValue(output));
            });
            return command;
        }

        /// <summary>Corners outside the picture are possible, a screen that is nowhere in it is a mistake.</summary>
        private static void CheckPlace(RangeCalibration calibration, string source)
        {
            Vector2D center = calibration.Screen.ToImagePx(calibration.Screen.ScreenSizeM * 0.5);
            if (!(center.X >= 0 && center.Y >= 0 && center.X < calibration.ImageWidth && center.Y < calibration.ImageHeight))
                throw new InputException(source, FormattableString.Invariant($"the middle of the screen lies at {center.X:F0},{center.Y:F0}, outside the image of {calibration.ImageWidth}x{calibration.ImageHeight}"), "check the points, and give the image's size with --image-size");
            Vector2D[] corners = calibration.Screen.CornersPx;
            if (Vector2D.Cross(corners[1] - corners[0], corners[3] - corners[0]) < 0)
                Console.Error.WriteLine("range: the picture is mirrored: right for a camera behind the screen, else the corners run the wrong way round");
        }

        private static Command Verify()
        {
            var file = new Argument<string>("CALIBRATION") { Description = "What 'calibrate screen' wrote." };
            var points = new Option<string>("--points") { HelpName = "FILE", Description = "JSON file with image_px and screen_m of points that the fit did not use.", Required = true };
            var limit = new Option<double>("--limit") { HelpName = "MM", Description = "Largest error that passes, mm.", DefaultValueFactory = _ => DefaultLimitMm };
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
            if (!(limitMm >= 0))
                throw new InputException("--limit", "must be a number of millimetres, 0 or more", "write it as 5");
            using ResultFile? file = output == null ? null : new ResultFile(output);
            Homography toScreen = calibration.Screen.ImageToScreen, toImage = toScreen.Inverse;
            var result = new JObject();
            if (output != null)
            {
                result["rms_px"] = PointErrors.Of(toImage, measured.ScreenM, measured.ImagePx, 1).Rms;
                result["rms_mm"] = PointErrors.Of(toScreen, measured.ImagePx, measured.ScreenM, 1000).Rms;
            }

            PointErrors mm = PointErrors.Of(toScreen, measured.VerifyImagePx, measured.VerifyScreenM, 1000);
            PointErrors px = PointErrors.Of(toImage, measured.VerifyScreenM, measured.VerifyImagePx, 1);
            if (mm.Count == 0)
                result["verify"] = new JObject { ["n"] = 0 };
            else
                result["verify"] = new JObject { ["n"] = mm.Count, ["median_mm"] = mm.Median, ["p95_mm"] = mm.P95, ["max_mm"] = mm.Max, ["median_px"] = px.Median, ["max_px"] = px.Max };
            Console.WriteLine(result.ToString());
            if (mm.Count > 0 && !(mm.Max <= limitMm))
            {
                Console.Error.WriteLine(FormattableString.Invariant($"range: the held-out error reaches {mm.Max:F2} mm, over the limit of {limitMm} mm; nothing was written"));
                return ExitCodes.CheckFailed;
            }

            if (file == null)
                return ExitCodes.Done;
            if (mm.Count == 0)
                Console.Error.WriteLine("range: no check points: the fit goes through its corners exactly and proves nothing; fire at known places and give them as \"verify\" in --points");
            JObject content = JObject.Parse(RangeCalibrationFile.Format(calibration));
            content.Merge(result);
            file.Stream.Write(Encoding.UTF8.GetBytes(content.ToString() + "\n"));
            file.Commit();
            return ExitCodes.Done;
        }
    }
}
