using System;
using System.CommandLine;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Host.Recordings;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Commands
{
    /// <summary>range info: what a recording holds, as JSON.</summary>
    internal static class InfoCommand
    {
        public static Command Create()
        {
            var input = new Argument<string>("INPUT") { Description = "An Azure Kinect recording, a video, or a folder of numbered images." };
            var command = new Command("info", "Says what a recording holds, as JSON; damage is listed under \"problems\".") { input };
            command.SetAction((parsed, interrupted) =>
            {
                JsonObject info = Describe(parsed.GetValue(input)!, interrupted);
                Console.WriteLine(info.ToJsonString(new JsonSerializerOptions { WriteIndented = true, Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping }));
                return Task.FromResult(ExitCodes.Done);
            });
            return command;
        }

        private static JsonObject Describe(string path, CancellationToken interrupted)
        {
            switch (FrameSources.Detect(path))
            {
                case FrameSourceKind.AzureKinectRecording:
                    using (var progress = new ProgressLine())
                    using (KinectRecording recording = KinectRecording.Open(path))
                        return new RecordingInfo(recording).Build(part => progress.Show(FormattableString.Invariant($"{part:P0}")), interrupted);
                case FrameSourceKind.ImageFolder:
                    return VideoInfo.OfImageFolder(path);
                default:
                    return VideoInfo.OfVideo(path);
            }
        }
    }
}
