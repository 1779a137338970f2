using System;
using System.CommandLine;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Studies;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate history DIR: the calibrations kept there, the best one and the trend.</summary>
    internal static class CalibrateHistoryCommand
    {
        public static Command Create()
        {
            var folder = new Argument<string>("DIR") { Description = "The folder given to --history, or any folder of calibrations." };
            var json = new Option<bool>("--json") { Description = "Print JSON in place of tables." };
            var command = new Command("history", "Calibrations in order of date, with errors, the best one and the trend.") { folder, json };
            command.SetAction(parsed =>
            {
                CalibrationHistory history = CalibrationHistory.Open(parsed.GetValue(folder)!);
                foreach (string problem in history.Problems)
                    Console.Error.WriteLine("range: " + problem);
                if (parsed.GetValue(json))
                {
                    var all = new JArray();
                    foreach (StudyTable table in history.Tables())
                        all.Add(JObject.Parse(table.ToJson()));
                    Console.WriteLine(all.ToString());
                    return ExitCodes.Done;
                }

                bool isFirst = true;
                foreach (StudyTable table in history.Tables())
                {
                    if (!isFirst)
                        Console.WriteLine();
                    table.Print(Console.Out);
                    isFirst = false;
                }

                return ExitCodes.Done;
            });
            return command;
        }
    }
}
