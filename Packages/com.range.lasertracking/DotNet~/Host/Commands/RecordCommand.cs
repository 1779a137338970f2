using System;
using System.CommandLine;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Recording;
using LaserTracking.Geometry;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Commands
{
    /// <summary>range record: writes the frames of any source into a recording in the Azure Kinect format.</summary>
    internal static class RecordCommand
    {
        public static Command Create()
        {
            var input = new Argument<string>("INPUT") { Description = "A recording, video, folder of pictures, or a simulation's scenario (.json). A recording is copied as it is, made whole where its recorder was killed." };
            var output = new Option<string>("--out") { HelpName = "FILE.mkv", Description = "File to write; one that exists is not overwritten.", Required = true };
            var camera = new Option<string>("--camera") { HelpName = "WHICH", Description = "screen (camera 0) or hand (camera 1), of a recording or simulation that has both.", DefaultValueFactory = _ => "screen" };
            var region = new Option<string?>("--region") { HelpName = "X,Y,W,H", Description = "Keeps only this part of the colour pictures, px; read back it stands at its place." };
            var calibration = new Option<string?>("--calibration") { HelpName = "FILE", Description = "Keeps only the part of the colour pictures that shows the screen." };
            var jpeg = new Option<int>("--jpeg") { HelpName = "QUALITY", Description = "1…100: colour as JPEG. Left out: every bit is kept." };
            var command = new Command("record", "Writes frames into a recording in the Azure Kinect format (.mkv).") { input, output, camera, region, calibration, jpeg };
            command.SetAction((parsed, interrupted) =>
            {
                string name = parsed.GetValue(input)!, path = parsed.GetValue(output)!, which = parsed.GetValue(camera)!;
                bool isHand = which == "hand" ? true : which == "screen" ? false : throw new InputException("--camera", $"\"{which}\" is not known", "give screen or hand");
                if (parsed.GetValue(jpeg) is < 0 or > 100)
                    throw new InputException("--jpeg", "must lie in 1…100", "90 is a usual quality");
                ResultFile.CheckNotRead(path, name, parsed.GetValue(calibration));
                PixelRegion? Part(IFrameSource source) => FindRegion(source, parsed.GetValue(region), parsed.GetValue(calibration));
                bool isWhole = parsed.GetResult(camera)!.Implicit && parsed.GetValue(region) == null && parsed.GetValue(calibration) == null && parsed.GetValue(jpeg) == 0;
                if (File.Exists(path))
                    throw new InputException(path, "exists already and is not overwritten", "name another file, or delete this one");
                if (isWhole && !CameraInput.IsScenario(name) && FrameSources.Detect(name) == FrameSourceKind.AzureKinectRecording)
                    return Task.FromResult(Copy(name, path, interrupted));
                using IFrameSource source = isHand ? CameraInput.OpenHands(name) : CameraInput.Open(name);
                return Task.FromResult(Record(source, path, new FrameRecorderSettings { Region = isHand ? null : Part(source), JpegQuality = parsed.GetValue(jpeg) }, interrupted));
            });
            return command;
        }

        private static int Record(IFrameSource source, string path, FrameRecorderSettings settings, CancellationToken interrupted)
        {
            settings.WaitsWhenFull = true;
            settings.FramesPerSecond = source.Info.NominalFramesPerSecond;
            using var progress = new ProgressLine();
            using var frame = new Frame();
            using var recorder = new FrameRecorder(path, settings);
            while (!interrupted.IsCancellationRequested && recorder.Problem.Length == 0 && source.TryRead(frame))
            {
                recorder.Add(frame);
                progress.Show(FormattableString.Invariant($"frame {frame.Index + 1}, {recorder.WrittenBytes >> 20} MiB"));
            }

            recorder.Dispose();
            progress.Clear();
            if (recorder.Problem.Length > 0)
            {
                // A shorter recording than was asked for is no result.
                File.Delete(path);
                throw new InputException(path, "cannot be recorded" + recorder.Problem[path.Length..].Split(';')[0].TrimStart(':'), "make room or choose another place");
            }

            if (recorder.RecordedFrames == 0)
                throw new InputException(source.Info.Name, "has no picture to record", "give another input");
            string rest = recorder.LeftOutPictures > 0 ? $"; {recorder.LeftOutPictures} missing pictures and such of another size or format are not in it" : "";
            Console.WriteLine(FormattableString.Invariant($"{path}: {recorder.RecordedFrames} frames, {recorder.WrittenBytes} bytes") + rest);
            return interrupted.IsCancellationRequested ? ExitCodes.Interrupted : ExitCodes.Done;
        }

        private static int Copy(string name, string path, CancellationToken interrupted)
        {
            using var progress = new ProgressLine();
            using KinectRecording recording = KinectRecording.Open(name);
            using var result = new ResultFile(path);
            long blocks;
            try
            {
                blocks = KinectRecordingCopier.Copy(recording, result.Stream, part => progress.Show(FormattableString.Invariant($"{part:P0}")), interrupted);
                result.Commit();
            }
            catch (IOException problem)
            {
                throw new InputException(path, "cannot be written (" + problem.Message.ReplaceLineEndings(" ").TrimEnd('.') + ")", "make room or choose another place");
            }

            progress.Clear();
            string damage = recording.Problems.Count > 0 ? FormattableString.Invariant($"; {recording.Problems.Count} problems of the input, the first: {recording.Problems[0].What}") : "";
            Console.WriteLine(FormattableString.Invariant($"{path}: {blocks} blocks copied") + damage);
            return interrupted.IsCancellationRequested ? ExitCodes.Interrupted : ExitCodes.Done;
        }

        private static PixelRegion? FindRegion(IFrameSource source, string? text, string? calibrationName)
        {
            if (text != null && calibrationName != null)
                throw new InputException("--region", "the calibration names a region too", "give one of --region and --calibration");
            (int width, int height) = (source.Info.Width, source.Info.Height);
            if (text != null)
            {
                string[] words = text.Split(',');
                int[] n = words.Select(word => int.TryParse(word, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && Math.Abs(value) < 1 << 20 ? value : int.MinValue).ToArray();
                if (n.Length != 4 || n.Contains(int.MinValue) || !PixelRegion.TryCreate(n[0], n[1], n[0] + n[2], n[1] + n[3], width, height, out PixelRegion named))
                    throw new InputException("--region", FormattableString.Invariant($"\"{text}\" is no part of a picture of {width}×{height}"), "write it like 200,100,640,400: left, top, width, height in px");
                return named;
            }

            if (calibrationName == null)
                return null;
            RangeCalibration calibration = RangeCalibrationFile.Read(calibrationName);
            if (calibration.ImageWidth != width || calibration.ImageHeight != height)
                throw new InputException(calibrationName, FormattableString.Invariant($"is for pictures of {calibration.ImageWidth}×{calibration.ImageHeight}, these have {width}×{height}"), "calibrate with pictures of this size");
            return ScreenRegion.TryFind(calibration, ScreenRegion.DefaultMarginPx, out PixelRegion screen)
                ? screen
                : throw new InputException(calibrationName, "the screen lies outside the picture", "calibrate again");
        }
    }
}
