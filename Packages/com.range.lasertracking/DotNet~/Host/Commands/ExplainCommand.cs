using System;
using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Explanations;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using LaserTracking.Detection;

namespace LaserTracking.Host.Commands
{
    /// <summary>range explain: why what a frame shows was a shot, or was none.</summary>
    internal static class ExplainCommand
    {
        public static Command Create()
        {
            var input = new Argument<string>("INPUT") { Description = "A recording, video or folder of numbered images, or a simulation's scenario (.json)." };
            var frame = new Option<int>("--frame") { HelpName = "N", Description = "Which frame, counted from 0.", Required = true };
            var at = new Option<string?>("--at") { HelpName = "X,Y", Description = "Only the candidate at this place, px, magnified; or why there is none." };
            var detector = new Option<string>("--detector") { HelpName = "NAME", Description = "shots (default), or another one by its name.", DefaultValueFactory = _ => "shots" };
            var calibration = new Option<string?>("--calibration") { HelpName = "FILE", Description = "Where the screen lies in the image: outside of it nothing counts." };
            var output = new Option<string?>("--out") { HelpName = "FILE.png", Description = "The picture; by default out/explain-N.png." };
            var command = new Command("explain", "Draws a frame with its candidates and the tests each passed or failed.") { input, frame, at, detector, calibration, output };
            command.SetAction((parsed, interrupted) =>
            {
                int index = parsed.GetValue(frame);
                if (index < 0)
                    throw new InputException("--frame", FormattableString.Invariant($"{index} is no frame"), "frames are counted from 0");
                string? place = parsed.GetValue(at);
                string name = parsed.GetValue(input)!;
                string picture = parsed.GetValue(output) ?? Path.Combine("out", FormattableString.Invariant($"explain-{index}.png"));
                ResultFile.CheckNotRead(picture, name, parsed.GetValue(calibration));
                IShotDetector chosen = RangeSession.CreateDetector(parsed.GetValue(detector)!);
                if (parsed.GetValue(calibration) is { } file)
                    chosen.SetScreenPolygon(RangeCalibrationFile.Read(file).Screen.OutlinePx);
                return Task.FromResult(Run(name, index, place == null ? null : ScreenPoints.Pair(place, ',', "--at"), chosen, picture, interrupted));
            });
            return command;
        }

        private static int Run(string name, int index, Vector2D? atPx, IShotDetector detector, string picture, CancellationToken interrupted)
        {
            using var file = new ResultFile(picture);
            using IFrameSource source = CameraInput.Open(name);
            using var progress = new ProgressLine();
            using ExplainedFrame explained = new FrameExaminer(detector).Run(source, name, index, atPx, progress, interrupted);
            progress.Clear();
            using Canvas canvas = ExplanationPicture.Draw(explained, atPx);
            file.Stream.Write(PngEncoder.Encode(canvas.Image));
            file.Commit();
            ExplanationText.Write(explained, atPx, Console.Out);
            Console.WriteLine();
            Console.WriteLine("the picture: " + picture);
            return ExitCodes.Done;
        }
    }
}
