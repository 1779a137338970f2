using System;
using System.CommandLine;
using System.Globalization;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Host.Studies;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Commands
{
    /// <summary>range study NAME: an experiment on the simulated range or on recorded clips.</summary>
    internal static class StudyCommand
    {
        internal const string DefaultSeeds = "201..205";

        public static Command Create()
        {
            string known = string.Join("\n", StudyList.All.Select(s => "  " + s.Name + ": " + s.What));
            var name = new Argument<string>("NAME") { Description = "Which experiment. Known:\n" + known };
            var seeds = new Option<string>("--seeds") { HelpName = "A..B", Description = "Seeds to run, from A to B.", DefaultValueFactory = _ => DefaultSeeds };
            var only = new Option<string?>("--only") { HelpName = "TEXT", Description = "Run only the cases whose names contain this." };
            var json = new Option<bool>("--json") { Description = "Prints JSON instead of a table." };
            var command = new Command("study", "Runs an experiment and prints its table with 95 % confidence intervals.") { name, seeds, only, json };
            command.SetAction((parsed, interrupted) =>
                Task.FromResult(Run(parsed.GetValue(name)!, parsed.GetValue(seeds)!, parsed.GetValue(only), parsed.GetValue(json), interrupted)));
            return command;
        }

        private static int Run(string name, string seeds, string? only, bool asJson, CancellationToken interrupted)
        {
            IStudy study = StudyList.All.FirstOrDefault(s => s.Name == name)
                ?? throw new InputException(name, "there is no such study", "known are " + string.Join(", ", StudyList.All.Select(s => s.Name)));
            (int first, int last) = ParseSeeds(seeds);
            StudyTable table;
            using (var progress = new ProgressLine())
                table = study.Run(new StudyOptions(first, last, progress, only), interrupted);
            if (asJson)
                Console.WriteLine(table.ToJson());
            else
                table.Print(Console.Out);
            return interrupted.IsCancellationRequested ? ExitCodes.Interrupted : ExitCodes.Done;
        }

        /// <exception cref="InputException">The text is no range.</exception>
        internal static (int First, int Last) ParseSeeds(string text)
        {
            string[] parts = text.Split("..");
            bool isRange = parts.Length is 1 or 2;
            if (isRange && int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int first)
                && int.TryParse(parts[^1], NumberStyles.None, CultureInfo.InvariantCulture, out int last) && last >= first)
                return (first, last);
            throw new InputException("--seeds", "\"" + text + "\" is no range of seeds", "write it like " + DefaultSeeds);
        }
    }
}
