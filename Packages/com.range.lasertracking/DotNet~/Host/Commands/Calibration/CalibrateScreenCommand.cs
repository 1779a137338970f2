using System;
using System.CommandLine;
using System.Linq;
using System.Text;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Sessions;
using LaserTracking.Patterns;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate screen: from the projected pattern, from measured points, or from four corners.</summary>
    internal static class CalibrateScreenCommand
    {
        public const double DefaultLimitMm = 5;
        private const double MinimumScreenM = 0.05;
        private const double MaximumScreenM = 100;

        /// <summary>How well somebody points at a corner in a picture, px.</summary>
        private const double HandSigmaPx = 0.5;

        public static Command Create()
        {
            var images = ImagesOption();
            var points = new Option<string?>("--points") { HelpName = "FILE", Description = "Instead: JSON file with image_px, screen_m and, better, verify." };
            var corners = new Option<string[]>("--corners") { HelpName = "X,Y", Description = "Instead: the screen's corners in the image, x,y four times, top-left first, clockwise.", AllowMultipleArgumentsPerToken = true };
            var size = new Option<string>("--size") { HelpName = "WxH", Description = "Width and height of the projected picture in metres: 3.73x2.26.", Required = true };
            var imageSize = new Option<string>("--image-size") { HelpName = "WxH", Description = "Width and height of the image in pixels, for --points and --corners.", DefaultValueFactory = _ => "1280x720" };
            var camera = new Option<string?>("--camera") { HelpName = "FILE", Description = "The camera with its lens, from 'calibrate board'. Without it --image finds what matters of the lens by itself." };
            var output = new Option<string>("--out") { HelpName = "FILE", Description = "The calibration to write.", DefaultValueFactory = _ => "screen.json" };
            var limit = LimitOption();
            var map = new Option<string?>("--map") { HelpName = "FILE.png", Description = "A picture of the errors over the screen, also when the calibration is refused." };
            var replace = new Option<bool>("--replace") { Description = "Take the place of the file that is there even when that one is better." };
            var history = new Option<string?>("--history") { HelpName = "DIR", Description = "Keep this calibration there too; see 'calibrate history'." };
            var date = new Option<string?>("--date") { HelpName = "YYYY-MM-DD", Description = "When the pictures were taken; needed with --history." };
            var mirrored = new Option<bool>("--mirrored") { Description = "The camera stands behind the screen: --points and --corners run the other way round in its picture." };
            var command = new Command("screen", "Fits image pixels to screen metres and proves the fit.") { images, points, corners, size, imageSize, camera, output, limit, map, replace, history, date, mirrored };
            command.SetAction((parsed, interrupted) =>
            {
                Vector2D sizeM = SizeM(parsed.GetValue(size)!);
                string[] inputs = parsed.GetValue(images) ?? [], given = parsed.GetValue(corners) ?? [];
                string? file = parsed.GetValue(points), picture = parsed.GetValue(map), folder = parsed.GetValue(history), day = parsed.GetValue(date), target = parsed.GetValue(output);
                int ways = (inputs.Length > 0 ? 1 : 0) + (file != null ? 1 : 0) + (given.Length > 0 ? 1 : 0);
                if (ways != 1)
                    throw new InputException("calibrate screen", ways == 0 ? "no points given" : "points given in several ways", "use one of --image INPUT, --points FILE and --corners");
                if (folder != null && day == null)
                    throw new InputException("--history", "the calibration has no date", "add --date YYYY-MM-DD, the day on which the pictures were taken");
                if (day != null && !DateOnly.TryParseExact(day, "yyyy-MM-dd", out _))
                    throw new InputException("--date", $"\"{day}\" is no date", "write it as 2026-11-22");
                foreach (string? result in new[] { target, picture })
                    ResultFile.CheckNotRead(result, [file, parsed.GetValue(camera), .. inputs]);
                if (picture != null && picture == target)
                    throw new InputException("--map", "is the name of the calibration too", "give the map a name of its own");
                double limitMm = LimitMm(parsed.GetValue(limit));
                LensCamera? lens = parsed.GetValue(camera) is string name ? LensCameraJson.ReadFile(name) : null;
                using ResultFile? written = new(target!), drawn = picture == null ? null : new ResultFile(picture);
                JObject? content = inputs.Length > 0
                    ? Automatic(inputs, sizeM, limitMm, lens, drawn, interrupted)
                    : ByHand(file, given, sizeM, parsed.GetValue(imageSize)!, parsed.GetResult(imageSize) is { Implicit: false }, limitMm, lens, drawn, parsed.GetValue(mirrored));
                if (content == null)
                    return System.Threading.Tasks.Task.FromResult(ExitCodes.CheckFailed);
                if (day != null)
                    content["date"] = day;
                byte[] bytes = Encoding.UTF8.GetBytes(content.ToString().ReplaceLineEndings("\n") + "\n");
                if (folder != null)
                    CalibrationHistory.Keep(folder, content, bytes);
                if (!parsed.GetValue(replace) && CalibrationHistory.WhyKept(target!, content) is string better)
                {
                    Console.Error.WriteLine($"range: {target}: {better}; it stays: --replace puts the new one in its place, --out FILE beside it");
                    return System.Threading.Tasks.Task.FromResult(ExitCodes.CheckFailed);
                }

                written.Stream.Write(bytes);
                written.Commit();
                return System.Threading.Tasks.Task.FromResult(ExitCodes.Done);
            });
            return command;
        }

        public static Option<string[]> ImagesOption() => new("--image")
        {
            HelpName = "INPUT", AllowMultipleArgumentsPerToken = true,
            Description = "What the camera saw of the pictures of 'calibrate pattern': a video, recording, folder of numbered images, one or more images, or a simulation's scenario (.json). At most 20 s are looked at.",
        };

        public static Option<double> LimitOption() => new("--limit") { HelpName = "MM", Description = "Largest held-out error that passes, mm.", DefaultValueFactory = _ => DefaultLimitMm };

        public static double LimitMm(double limit) =>
            limit >= 0 ? limit : throw new InputException("--limit", "must be a number of millimetres, 0 or more", "write it as 5");

        private static Vector2D SizeM(string text)
        {
            Vector2D sizeM = ScreenPoints.Pair(text, 'x', "--size");
            return Math.Min(sizeM.X, sizeM.Y) >= MinimumScreenM && Math.Max(sizeM.X, sizeM.Y) <= MaximumScreenM
                ? sizeM
                : throw new InputException("--size", $"\"{text}\" is no screen of 0.05 to 100 metres", "write it as 3.73x2.26");
        }

        /// <summary>The calibration with its proof; null when it is refused.</summary>
        private static JObject? Automatic(string[] inputs, Vector2D sizeM, double limitMm, LensCamera? lens, ResultFile? map, System.Threading.CancellationToken interrupted)
        {
            ScreenCalibration found = new ScreenCalibrator(sizeM, limitMm, lens).Calibrate(PatternCapture.Look(inputs, lens, interrupted));
            if (map != null)
            {
                using Canvas canvas = ErrorMap.Draw(found, sizeM, limitMm);
                map.Stream.Write(PngEncoder.Encode(canvas.Image));
                map.Commit();
            }

            JObject result = ScreenReport.OfPattern(found);
            Console.WriteLine(result.ToString());
            ScreenReport.Say(found);
            return found.IsAccepted ? Merged(new RangeCalibration(found.Screen!, found.View.ImageWidth, found.View.ImageHeight, null, false, found.Residuals()), result) : null;
        }

        private static JObject? ByHand(string? file, string[] corners, Vector2D sizeM, string imageSize, bool isSizeGiven, double limitMm, LensCamera? lens, ResultFile? map, bool isMirrored)
        {
            if (map != null)
                throw new InputException("--map", "there is a map of the pattern's points only", "use it with --image");
            string source = file ?? "--corners";
            ScreenPoints measured = file != null ? ScreenPoints.Read(file) : ScreenPoints.FromCorners(corners, sizeM);
            (int width, int height) = measured.ImageSize ?? (lens == null ? ScreenPoints.PixelSize(imageSize) : (lens.Pinhole.Width, lens.Pinhole.Height));
            if (!ScreenGeometry.TryFit(measured.ImagePx, measured.ScreenM, sizeM, lens, HandSigmaPx, out ScreenGeometry? screen, out string reason))
                throw new InputException(source, reason, "measure these points again");
            var calibration = new RangeCalibration(screen!, width, height, null);
            ScreenReport.CheckPlace(calibration, source, isMirrored);
            ScreenReport.CheckOnScreen(measured.ScreenM, sizeM, "screen_m", source);
            ScreenReport.CheckOnScreen(measured.VerifyScreenM, sizeM, "verify.screen_m", source);
            bool isSure = file != null && (measured.ImageSize != null || lens != null || isSizeGiven);
            ScreenReport.CheckInside(measured.ImagePx, "image_px", calibration, source, isSure);
            ScreenReport.CheckInside(measured.VerifyImagePx, "verify.image_px", calibration, source, isSure);
            PointProof proof = PointProof.Of(screen!, measured with { ImageSize = (width, height) }, sizeM, lens, HandSigmaPx, limitMm);
            var result = new JObject
            {
                ["rms_px"] = PointErrors.Of(measured.ImagePx.Zip(measured.ScreenM, (px, m) => (screen!.ToImagePx(m) - px).Length).ToArray()).Rms,
                ["rms_mm"] = PointErrors.Of(measured.ImagePx.Zip(measured.ScreenM, (px, m) => (screen!.ToScreenM(px) - m).Length * 1000).ToArray()).Rms,
            };
            proof.AddTo(result);
            Console.WriteLine(result.ToString());
            return proof.Passes("; nothing was written") ? Merged(new RangeCalibration(screen!, width, height, null, false, proof.Residuals), result) : null;
        }

        private static JObject Merged(RangeCalibration calibration, JObject result)
        {
            JObject content = JObject.Parse(RangeCalibrationFile.Format(calibration));
            content.Merge(result);
            return content;
        }
    }
}
