using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Sessions;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Commands
{
    /// <summary>range demo: the main job on the shipped sample, a simulated range with two cameras and several shooters.</summary>
    internal static class DemoCommand
    {
        private const string InputName = "Assets/Sources/demo.scenario.json";

        public static Command Create()
        {
            var output = new Option<string>("--out") { HelpName = "DIR", Description = "Folder for events.jsonl, truth.json and report.html.", DefaultValueFactory = _ => Path.Combine("out", "demo") };
            var seed = new Option<int?>("--seed") { HelpName = "N", Description = "Another simulation of the same scenario." };
            var command = new Command("demo", "The main job on the shipped sample: two cameras, several shooters, moving targets; no camera needed.") { output, seed };
            command.SetAction((parsed, interrupted) => Task.FromResult(Run(parsed.GetValue(output)!, parsed.GetValue(seed), interrupted)));
            return command;
        }

        private static int Run(string folder, int? seed, CancellationToken interrupted)
        {
            string root = RepositoryFolder.Find();
            string scenarioFile = Path.Combine(root, "Assets", "Sources", "demo.scenario.json");
            SessionPlan plan = SimulatedSession.Create(scenarioFile, InputName, null, seed, out SimulatedRange range);
            using IFrameSource screenCamera = plan.ScreenCamera;
            using IFrameSource? handCamera = plan.HandCamera;
            var outputs = new SessionOutputs(Path.Combine(folder, "events.jsonl"), null, folder) { BackgroundPng = DrawPicture(range) };
            int exitCode = outputs.Run(plan, "Demo session", interrupted);
            if (exitCode == ExitCodes.Done)
            {
                SimulationTruthWriter.Write(range.Truth, InputName, range.Scenario, Path.Combine(folder, "truth.json"));
                TruthComparison.Print(outputs.Recorder, range.Truth);
            }

            System.Console.WriteLine($"the report: {Path.Combine(folder, "report.html")}");
            return exitCode;
        }

        /// <summary>What the projector showed at the beginning, for the report.</summary>
        private static byte[] DrawPicture(SimulatedRange range)
        {
            using var picture = new Image();
            range.DrawPicture(0, picture);
            return PngEncoder.Encode(picture);
        }
    }
}
