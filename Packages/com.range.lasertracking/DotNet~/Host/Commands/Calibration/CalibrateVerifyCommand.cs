using System;
using System.CommandLine;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Patterns;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate verify: errors of a calibration on points that it has not seen.</summary>
    internal static class CalibrateVerifyCommand
    {
        /// <summary>Points that are met so exactly were fitted to, m: nobody shoots so well.</summary>
        private const double FittedM = 1e-8;

        public static Command Create()
        {
            var file = new Argument<string>("CALIBRATION") { Description = "What 'calibrate screen' wrote." };
            var points = new Option<string?>("--points") { HelpName = "FILE", Description = "JSON file with image_px and screen_m of points that the fit did not use: shots at known places." };
            Option<string[]> images = CalibrateScreenCommand.ImagesOption();
            Option<double> limit = CalibrateScreenCommand.LimitOption();
            var command = new Command("verify", "Errors of a calibration on points not used in the fit; exit 1 over the limit, or with fewer than four points in four parts of the screen.") { file, points, images, limit };
            command.SetAction((parsed, interrupted) =>
            {
                string? measured = parsed.GetValue(points);
                string[] inputs = parsed.GetValue(images) ?? [];
                if (measured != null && inputs.Length > 0)
                    throw new InputException("calibrate verify", "points given in several ways", "use one of --points FILE and --image INPUT");
                double limitMm = CalibrateScreenCommand.LimitMm(parsed.GetValue(limit));
                string name = parsed.GetValue(file)!;
                RangeCalibration calibration = RangeCalibrationFile.Read(name);
                if (measured == null && inputs.Length == 0)
                    throw calibration.IsUnverified
                        ? new InputException(name, "this calibration is unverified: nothing but its own few points says that it is right", "fire check shots at known places and give them with --points FILE, or show the pattern and give --image INPUT")
                        : new InputException("calibrate verify", "no points given", "use one of --points FILE and --image INPUT");
                ScreenPoints seen = measured != null ? Measured(measured, calibration) : Seen(inputs, calibration, interrupted);
                PointProof proof = PointProof.Of(calibration.Screen, seen, calibration.Screen.ScreenSizeM, calibration.Screen.Camera, 1, limitMm);
                if (calibration.IsUnverified && seen.VerifyImagePx.Zip(seen.VerifyScreenM, (px, m) => (calibration.Screen.ToScreenM(px) - m).Length).All(off => off < FittedM))
                    throw new InputException(measured ?? inputs[0], "these are the points that the calibration was fitted to: they prove nothing", "give shots at other known places");
                var result = new JObject();
                proof.AddTo(result);
                Console.WriteLine(result.ToString());
                return Task.FromResult(proof.Passes(string.Empty) && proof.IsEnough() ? ExitCodes.Done : ExitCodes.CheckFailed);
            });
            return command;
        }

        private static ScreenPoints Measured(string file, RangeCalibration calibration)
        {
            ScreenPoints points = ScreenPoints.Read(file);
            if (points.ImagePx.Length == 0)
                throw new InputException(file, "holds no point, so nothing is checked", "give points as image_px and screen_m");
            ScreenReport.CheckOnScreen(points.ScreenM, calibration.Screen.ScreenSizeM, "screen_m", file);
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
