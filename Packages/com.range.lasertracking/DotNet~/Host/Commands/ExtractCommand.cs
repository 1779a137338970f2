using System;
using System.CommandLine;
using System.Globalization;
using System.Threading.Tasks;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Host.Recordings;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Commands
{
    /// <summary>range extract: every capture's payloads as files, and one line each in frames.jsonl.</summary>
    internal static class ExtractCommand
    {
        public static Command Create()
        {
            var input = new Argument<string>("RECORDING") { Description = "An Azure Kinect recording (.mkv)." };
            var output = new Option<string>("--out") { HelpName = "DIR", Description = "Folder for the payloads and frames.jsonl.", Required = true };
            var captures = new Option<string?>("--captures") { HelpName = "A..B", Description = "Only captures A..B, counted from 0, both included." };
            var hashesOnly = new Option<bool>("--hashes-only") { Description = "Writes frames.jsonl without the payloads." };
            var command = new Command("extract", "Takes a recording apart: every payload as a file, as the camera delivered it.") { input, output, captures, hashesOnly };
            command.SetAction((parsed, interrupted) =>
            {
                (int first, int last) = Range(parsed.GetValue(captures));
                using KinectRecording recording = KinectRecording.Open(parsed.GetValue(input)!);
                var options = new ExtractOptions { OutputFolder = parsed.GetValue(output)!, FirstCapture = first, LastCapture = last, HashesOnly = parsed.GetValue(hashesOnly) };
                using var progress = new ProgressLine();
                ExtractResult result = new RecordingExtractor(recording, options).Run(part => progress.Show(FormattableString.Invariant($"{part:P0}")), interrupted);
                progress.Clear();
                Console.WriteLine(result.ToString());
                foreach (var problem in recording.Problems)
                    Console.Error.WriteLine($"range: {parsed.GetValue(input)}: {(problem.Offset >= 0 ? FormattableString.Invariant($"byte {problem.Offset}: ") : string.Empty)}{problem.What}");
                return Task.FromResult(result.WasCancelled ? ExitCodes.Interrupted : ExitCodes.Done);
            });
            return command;
        }

        private static (int First, int Last) Range(string? text)
        {
            if (text == null)
                return (0, int.MaxValue);
            string[] ends = text.Split("..");
            if (ends.Length == 2 && int.TryParse(ends[0], NumberStyles.None, CultureInfo.InvariantCulture, out int first) &&
                int.TryParse(ends[1], NumberStyles.None, CultureInfo.InvariantCulture, out int last) && first <= last)
                return (first, last);
            throw new InputException("--captures", $"\"{text}\" is no range", "write it as 0..9");
        }
    }
}
