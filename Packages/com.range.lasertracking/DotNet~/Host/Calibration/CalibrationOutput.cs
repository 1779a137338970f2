using System;
using System.CommandLine;
using System.Linq;
using System.Text;
using LaserTracking.Host.Sessions;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Where a calibration goes: its file, unless a better one is there, and the history.</summary>
    internal sealed class CalibrationOutput
    {
        private readonly Option<string> _output;
        private readonly Option<bool> _replace = new("--replace") { Description = "Take the place of the file that is there even when that one is better." };
        private readonly Option<string?> _history = new("--history") { HelpName = "DIR", Description = "Keep this calibration there too, whether better or not; see 'calibrate history'." };
        private readonly Option<string?> _date = new("--date") { HelpName = "YYYY-MM-DD", Description = "When the pictures were taken; needed with --history." };

        /// <param name="usualName">Of the file.</param>
        public CalibrationOutput(string usualName)
        {
            _output = new Option<string>("--out") { HelpName = "FILE", Description = "The calibration to write.", DefaultValueFactory = _ => usualName };
        }

        public void AddTo(Command command)
        {
            foreach (Option option in new Option[] { _output, _replace, _history, _date })
                command.Add(option);
        }

        /// <summary>Refuses, before any work, what could not be written in the end.</summary>
        public void Check(ParseResult parsed, params string?[] inputs)
        {
            ResultFile.CheckNotRead(parsed.GetValue(_output), inputs);
            string? date = parsed.GetValue(_date);
            if (parsed.GetValue(_history) != null && date == null)
                throw new InputException("--history", "the calibration has no date", "add --date YYYY-MM-DD, the day on which the pictures were taken");
            if (date != null && !DateOnly.TryParseExact(date, "yyyy-MM-dd", out _))
                throw new InputException("--date", $"\"{date}\" is no date", "write it as 2026-11-22");
        }

        /// <summary>Writes, prints a summary, and says what was left out. Exit code 1 when a better calibration keeps its place.</summary>
        public int Write(ParseResult parsed, JObject calibration)
        {
            if (parsed.GetValue(_date) is string date)
                calibration["date"] = date;
            byte[] content = Encoding.UTF8.GetBytes(calibration.ToString(Formatting.Indented).ReplaceLineEndings("\n") + "\n");
            foreach (JToken view in calibration["left_out"]!)
                Console.Error.WriteLine($"range: {view["view"]}: left out: {view["why"]}");
            foreach (JToken note in calibration["notes"]!)
                Console.Error.WriteLine("range: " + note);
            string output = parsed.GetValue(_output)!;
            string? better = parsed.GetValue(_replace) ? null : CalibrationHistory.WhyKept(output, calibration);
            using ResultFile? file = better == null ? new ResultFile(output) : null;
            if (parsed.GetValue(_history) is string folder)
                CalibrationHistory.Keep(folder, calibration, content);
            file?.Stream.Write(content);
            file?.Commit();

            if (output != "-")
                Console.WriteLine(Summary(calibration).ToString(Formatting.Indented));
            if (better == null)
                return ExitCodes.Done;
            Console.Error.WriteLine($"range: {output}: {better}; it stays: --replace puts the new one in its place, --out FILE beside it");
            return ExitCodes.CheckFailed;
        }

        private static JObject Summary(JObject calibration)
        {
            string[] shown = { "kind", "rms_px", "held_out", "image_size", "K", "dist", "R", "T", "baseline", "epipolar", "std", "left_out" };
            var summary = new JObject();
            foreach (string name in shown.Where(name => calibration[name] != null))
                summary[name] = calibration[name];
            summary["views"] = (calibration["views"] as JArray)?.Count;
            return summary;
        }
    }
}
