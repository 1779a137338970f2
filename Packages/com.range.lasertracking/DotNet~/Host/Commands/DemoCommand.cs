using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Host.Pictures;
using LaserTracking.Host.Scenes;
using LaserTracking.Host.Sessions;
using LaserTracking.Imaging;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

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
            SceneModel scene = UnitySceneReader.Read(Path.Combine(root, "Assets", "Scenes", "Range.unity"));
            SimulationScenario scenario = SimulationScenarioFile.Read(scenarioFile);
            if (seed is { } other)
                scenario.Seed = other;

            var range = new SimulatedRange(scenario, scene);
            using IFrameSource screenCamera = new PrefetchingFrameSource(range.CreateColorSource());
            using IFrameSource handCamera = new PrefetchingFrameSource(range.CreateDepthSource());
            var plan = new SessionPlan
            {
                ScreenCamera = screenCamera,
                HandCamera = handCamera,
                HandClockOffsetUs = range.Truth.ColorClockUs(0) - range.Truth.DepthClockUs(0),
                Calibration = range.Calibration,
                CalibrationName = "simulation",
                CameraTiming = new CameraTimingSettings { ExposureUs = scenario.ColorCamera.ExposureUs, RowUs = scenario.ColorCamera.RollingShutterRowUs },
                Scene = scene,
                SceneTimeZeroUs = range.Truth.ColorClockUs(0),
                Inputs = new[] { new SessionInput(InputName, InputHash.Of(scenarioFile).Sha256) },
                Seed = scenario.Seed,
            };
            var outputs = new SessionOutputs(Path.Combine(folder, "events.jsonl"), null, folder) { BackgroundPng = DrawPicture(range) };
            int exitCode = outputs.Run(plan, "Demo session", interrupted);
            if (exitCode == ExitCodes.Done)
            {
                SimulationTruthWriter.Write(range.Truth, InputName, scenario, Path.Combine(folder, "truth.json"));
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
