using System;
using System.CommandLine;
using System.Collections.Generic;
using System.Threading.Tasks;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate verify: errors of a calibration on points that it has not seen.</summary>
    internal static class CalibrateVerifyCommand
    {
        public static Command Create()
        {
            var file = new Argument<string>("CALIBRATION") { Description = "What 'calibrate screen' wrote." };
            var points = new Option<string?>("--points") { HelpName = "FILE", Description = "JSON file with image_px and screen_m of points that the fit did not use: shots at known places." };
            Option<string[]> images = CalibrateScreenCommand.ImagesOption();
            Option<double> limit = CalibrateScreenCommand.LimitOption();
            var command = new Command("verify", "Errors of a calibration on points not used in the fit; exit 1 over the limit.") { file, points, images, limit };
            command.SetAction((parsed, interrupted) =>
            {
                string? measured = parsed.GetValue(points);
                string[] inputs = parsed.GetValue(images) ?? [];
                if (measured == null == (inputs.Length == 0))
                    throw new InputException("calibrate verify", measured == null ? "no points given" : "points given in several ways", "use one of --points FILE and --image INPUT");
                double limitMm = CalibrateScreenCommand.LimitMm(parsed.GetValue(limit));
                RangeCalibration calibration = RangeCalibrationFile.Read(parsed.GetValue(file)!);
                ScreenPoints seen = measured != null ? Measured(measured, calibration) : Seen(inputs, calibration, interrupted);
                Console.WriteLine(ScreenReport.OfPoints(calibration.Screen, seen, withFit: false).ToString());
                return Task.FromResult(ScreenReport.Passes(calibration.Screen, seen, limitMm, string.Empty) ? ExitCodes.Done : ExitCodes.CheckFailed);
            });
            return command;
        }

        private static ScreenPoints Measured(string file, RangeCalibration calibration)
        {
            ScreenPoints points = ScreenPoints.Read(file);
            if (points.ImagePx.Length == 0)
                throw new InputException(file, "holds no point, so nothing is checked", "give points as image_px and screen_m");
            ScreenReport.CheckInside(points.ImagePx, "image_px", calibration, file, isSure: false);
            return points.AsVerify();
        }

        private static ScreenPoints Seen(string[] inputs, RangeCalibration calibration, System.Threading.CancellationToken interrupted)
        {
            ScreenPatternView view = PatternCapture.Look(inputs, calibration.Screen.Camera, interrupted);
            if (view.ImageWidth != calibration.ImageWidth || view.ImageHeight != calibration.ImageHeight)
                throw new InputException(inputs[0], FormattableString.Invariant($"its pictures are {view.ImageWidth}x{view.ImageHeight}, the calibration is for {calibration.ImageWidth}x{calibration.ImageHeight}"), "give pictures of the camera's usual size");
            List<Vector2D> px = [], m = [];
            foreach (ScreenPoint point in (ScreenPoint[])[.. view.First, .. view.Second])
            {
                if (point.State != ScreenPointState.Measured)
                    continue;
                px.Add(point.ImagePx);
                m.Add(new Vector2D(point.Place.X * calibration.Screen.ScreenSizeM.X, point.Place.Y * calibration.Screen.ScreenSizeM.Y));
            }

            if (px.Count == 0)
                throw new InputException(inputs[0], "no projected pattern was recognised in it", "show the pictures of 'calibrate pattern' full screen, in focus");
            return new ScreenPoints([], [], [.. px], [.. m], null);
        }
    }
}
