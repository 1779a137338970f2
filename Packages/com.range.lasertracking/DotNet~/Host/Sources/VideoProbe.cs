using System;
using System.Diagnostics;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using System.Threading.Tasks;

namespace LaserTracking.Host.Sources
{
    /// <summary>What ffprobe says about a file's first video stream, without decoding it.</summary>
    internal sealed class VideoProbe
    {
        private VideoProbe(string path, JsonElement root)
        {
            JsonElement stream = root.GetProperty("streams")[0];
            JsonElement format = root.GetProperty("format");
            Path = path;
            ContainerFormat = Text(format, "format_name") ?? "";
            Codec = Text(stream, "codec_name") ?? "unknown";
            Width = Integer(stream, "width");
            Height = Integer(stream, "height");
            if (Math.Abs(Rotation(stream)) % 180 == 90)
                (Width, Height) = (Height, Width);
            FramesPerSecond = Ratio(Text(stream, "avg_frame_rate")) ?? Ratio(Text(stream, "r_frame_rate")) ?? 0;
            DurationUs = Microseconds(Text(stream, "duration")) ?? Microseconds(Text(format, "duration"));
            StartUs = Microseconds(Text(stream, "start_time")) ?? 0;
            DeclaredFrames = long.TryParse(Text(stream, "nb_frames"), NumberStyles.None, CultureInfo.InvariantCulture, out long frames)
                ? frames
                : null;
        }

        public string Path { get; }

        public string ContainerFormat { get; }

        public string Codec { get; }

        /// <summary>As shown, after the rotation that the file asks for.</summary>
        public int Width { get; }

        public int Height { get; }

        /// <summary>Mean over the file; 0 when unknown.</summary>
        public double FramesPerSecond { get; }

        public long? DurationUs { get; }

        /// <summary>Presentation time of the first frame.</summary>
        public long StartUs { get; }

        /// <summary>As the container counts them, with those that players leave out.</summary>
        public long? DeclaredFrames { get; }

        /// <exception cref="InputException">ffprobe is missing, or the file is no video.</exception>
        public static VideoProbe Open(string path)
        {
            string program = FfmpegProgram.Require("ffprobe", path);
            string output = Run(program, path, out string problem,
                "-show_entries", "stream:stream_side_data=rotation:stream_tags=rotate:format", "-of", "json");
            JsonElement root = output.Length == 0 ? default : JsonDocument.Parse(output).RootElement;
            bool hasFormat = root.ValueKind == JsonValueKind.Object && root.TryGetProperty("format", out _);
            if (!hasFormat)
                throw new InputException(path, "is not a video (" + problem + ")", "give a recording, a video or a folder of images");
            bool hasVideo = root.TryGetProperty("streams", out JsonElement streams) && streams.GetArrayLength() > 0;

            // ffmpeg takes text for drawings made of letters.
            if (!hasVideo || Text(root.GetProperty("format"), "format_name") == "tty")
                throw new InputException(path, "holds no video", "give a recording, a video or a folder of images");
            var probe = new VideoProbe(path, root);
            if (probe.Width <= 0 || probe.Height <= 0)
                throw new InputException(path, "holds a video without a picture size", "record or copy it again");
            return probe;
        }

        /// <summary>Number of frames that a player shows, counted without decoding.</summary>
        public long CountFrames(out string problem)
        {
            string output = Run(FfmpegProgram.Require("ffprobe", Path), Path, out problem, "-show_entries", "packet=flags", "-of", "csv=p=0");
            return output.Split('\n').LongCount(line => line.Trim().Length > 0 && !line.Contains('D'));
        }

        /// <summary>Whether a message of ffmpeg's says that the file ends too early.</summary>
        public static bool MeansCut(string message) =>
            message.Contains("ended prematurely", StringComparison.Ordinal) || message.Contains("partial file", StringComparison.Ordinal);

        /// <summary>How ffmpeg is told a path, whatever it looks like.</summary>
        public static string InputOf(string path) => "file:" + System.IO.Path.GetFullPath(path);

        private static string Run(string program, string path, out string problem, params ReadOnlySpan<string> arguments)
        {
            var start = new ProcessStartInfo(program) { RedirectStandardOutput = true, RedirectStandardError = true, CreateNoWindow = true };
            foreach (string argument in new[] { "-v", "error", "-protocol_whitelist", "file,pipe", "-select_streams", "V:0" })
                start.ArgumentList.Add(argument);
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            start.ArgumentList.Add(InputOf(path));
            using Process process = Process.Start(start) ?? throw new InvalidOperationException("ffprobe did not start");
            Task<string> errors = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            string last = errors.Result.Split('\n').Select(FfmpegStatusReader.Condense).LastOrDefault(line => line.Length > 0) ?? "";
            problem = last.Replace(InputOf(path) + ": ", "", StringComparison.Ordinal);
            return output;
        }

        private static string? Text(JsonElement element, string name) =>
            element.TryGetProperty(name, out JsonElement value) ? value.ToString() : null;

        private static int Integer(JsonElement element, string name) =>
            element.TryGetProperty(name, out JsonElement value) && value.TryGetInt32(out int number) ? number : 0;

        private static long? Microseconds(string? seconds) =>
            double.TryParse(seconds, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value)
                ? (long)Math.Round(value * 1e6)
                : null;

        /// <summary>"30000/1001"; null for "0/0".</summary>
        private static double? Ratio(string? text)
        {
            string[] parts = (text ?? "").Split('/');
            if (parts.Length != 2 || !double.TryParse(parts[0], NumberStyles.Float, CultureInfo.InvariantCulture, out double numerator)
                || !double.TryParse(parts[1], NumberStyles.Float, CultureInfo.InvariantCulture, out double denominator))
            {
                return null;
            }

            return numerator > 0 && denominator > 0 ? numerator / denominator : null;
        }

        private static int Rotation(JsonElement stream)
        {
            if (stream.TryGetProperty("side_data_list", out JsonElement list))
            {
                foreach (JsonElement item in list.EnumerateArray())
                {
                    if (item.TryGetProperty("rotation", out JsonElement rotation) && rotation.TryGetDouble(out double degrees))
                        return (int)Math.Round(degrees);
                }
            }

            return 0;
        }
    }
}
