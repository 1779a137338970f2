using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Host.Sessions;
using LaserTracking.Session;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies
{
    /// <summary>
    /// A session of ten simulated minutes with two cameras, recorded as it runs and run again twice from its folder: the events must be
    /// the same to the byte. Needs some 3.5 GB of temporary space.
    /// </summary>
    internal sealed class SessionStudy : IStudy
    {
        private const double DurationS = 600;

        public string Name => "session";

        public string What => "ten simulated minutes recorded and replayed twice: are the events the same to the byte? (3.5 GB of temporary space)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("10 min, 320×180 NV12 at 30 frames/s, depth 320×288 at 15, four shooters, 40 shots a minute", "seed", "run", "frames", "shots", "event lines", "same bytes", "MB recorded", "took s");
            for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                RunSeed(seed, options, table, interrupted);
            table.Notes.Add("The files as they are, to the last byte. Build " + SessionLog.ThisBuild + ".");
            return table;
        }

        private static void RunSeed(int seed, StudyOptions options, StudyTable table, CancellationToken interrupted)
        {
            string folder = Directory.CreateTempSubdirectory("range-session-study-").FullName;
            try
            {
                string scenario = Path.Combine(folder, "scenario.json"), session = Path.Combine(folder, "session");
                File.WriteAllText(scenario, SimulationScenarioFile.ToJson(Scenario(seed)));
                string? recorded = null;
                for (int run = 0; run <= 2 && !interrupted.IsCancellationRequested; run++)
                {
                    options.Progress.Show(FormattableString.Invariant($"seed {seed}, {(run == 0 ? "recording" : "replay " + run)}"));
                    string events = Path.Combine(folder, run + ".jsonl");
                    var watch = Stopwatch.StartNew();
                    SessionPlan plan = run == 0 ? SimulatedSession.Create(scenario, "scenario.json", null, null, out _) : SessionFolder.Open(session, out _);
                    SessionRecorder found;
                    using (IFrameSource screen = plan.ScreenCamera)
                    using (IFrameSource? hands = plan.HandCamera)
                        found = run == 0 ? Record(session, plan, events, interrupted) : Play(plan, events, interrupted);
                    double seconds = watch.Elapsed.TotalSeconds;
                    string hash = HashOf(events);
                    recorded ??= hash;
                    table.Add(seed, run == 0 ? "recorded" : "replay " + run, found.Frames.Count, found.ShotCount, File.ReadLines(events).Count(), run == 0 ? "-" : hash == recorded ? "yes" : "NO",
                        run == 0 ? new DirectoryInfo(session).GetFiles().Sum(file => file.Length) / 1e6 : double.NaN, seconds);
                }
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        private static SessionRecorder Record(string session, SessionPlan plan, string events, CancellationToken interrupted)
        {
            SessionRecorder? found = null;
            SessionFolder.Record(session, plan, null, null, final =>
            {
                found = Play(final, events, interrupted);
                return ExitCodes.Done;
            });
            return found!;
        }

        private static SessionRecorder Play(SessionPlan plan, string events, CancellationToken interrupted)
        {
            var found = new SessionRecorder();
            using FileStream file = File.Create(events);
            RangeSession.Run(plan, new EventSinkGroup(new IEventSink[] { found, new JsonLinesSink(file) }), interrupted, found);
            return found;
        }

        private static SimulationScenario Scenario(int seed)
        {
            var scenario = new SimulationScenario { Name = "ten minutes", Seed = seed, DurationS = DurationS };
            scenario.ColorCamera.Width = 320;
            scenario.ColorCamera.Height = 180;
            scenario.ColorCamera.Format = Imaging.PixelFormat.Nv12;
            scenario.ColorCamera.DroppedShare = 0.01;
            scenario.DepthCamera.Binned = true;
            scenario.DepthCamera.FramesPerSecond = 15;
            scenario.DepthCamera.ClockOffsetUs = 123456789;
            for (int i = 0; i < 4; i++)
                scenario.Shooters.Add(new ShooterSettings { Name = "shooter " + (i + 1), OffsetXM = (i - 1.5) * 0.7 });
            scenario.Generator.ShotsPerMinute = 40;
            return scenario;
        }

        private static string HashOf(string events)
        {
            using FileStream stream = File.OpenRead(events);
            return Convert.ToHexString(SHA256.HashData(stream));
        }
    }
}
