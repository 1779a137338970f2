using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>What only a process of its own shows: Ctrl-C, closed pipes, the same bytes with and without vector instructions.</summary>
    public sealed class ProcessTests
    {
        [Test]
        public void Demo_CtrlC_KeepsWhatWasFinished()
        {
            if (OperatingSystem.IsWindows())
                Assert.Ignore("signals are sent with kill");
            using var folder = new TemporaryFolder();
            using var range = new RangeProcess(folder.Path, null, "demo");
            WaitFor(() => File.Exists(folder.File("out/demo/events.jsonl.part")));
            range.Interrupt();
            range.Output.ReadToEnd();
            (int exitCode, string error) = range.WaitForExit();
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Interrupted), error);
            Assert.That(error, Is.EqualTo("range: interrupted; what was finished is kept\n"));
            Assert.That(Directory.GetFiles(folder.File("out/demo")).Select(Path.GetFileName).Order(), Is.EqualTo(new[] { "events.jsonl", "report.html" }));
            Assert.That(File.ReadLines(folder.File("out/demo/events.jsonl")).Last(), Does.StartWith("{\"type\":\"end\""));
        }

        [Test]
        public void Record_Killed_GivesEveryFrameThatWasInTheFile()
        {
            const int FrameBytes = 320 * 180 * 3 / 2;
            using var folder = new TemporaryFolder();
            File.WriteAllText(folder.File("s.json"), "{\"name\":\"s\",\"seed\":3,\"duration_s\":600,\"color_camera\":{\"width\":320,\"height\":180,\"format\":\"nv12\"}}");
            using (var range = new RangeProcess(folder.Path, null, "record", "s.json", "--out", "r.mkv"))
            {
                WaitFor(() => File.Exists(folder.File("r.mkv")) && new FileInfo(folder.File("r.mkv")).Length > 30 * FrameBytes);
                range.Kill();
            }

            (int exitCode, string output, _) = CommandLine.Run("info", folder.File("r.mkv"));
            Assert.That(exitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(output, Does.Contain("\"truncated\": true").And.Contain("stopped before it could finish"));
            long frames = long.Parse(Regex.Match(output, "\"captures\": ([0-9]+)").Groups[1].Value, System.Globalization.CultureInfo.InvariantCulture);
            Assert.That(frames, Is.EqualTo(new FileInfo(folder.File("r.mkv")).Length / FrameBytes), "every frame that was in the file");
            Assert.That(frames, Is.GreaterThanOrEqualTo(29));
        }

        [Test]
        [Category("Reference")]
        public void Replay_CtrlCWhilePaced_EndsAtOnceWithAWholeFile()
        {
            if (OperatingSystem.IsWindows())
                Assert.Ignore("signals are sent with kill");
            using var folder = new TemporaryFolder();
            using var range = new RangeProcess(folder.Path, null, "replay", Recording, "--paced", "--events", "e.jsonl");
            WaitFor(() => File.Exists(folder.File("e.jsonl.part")));
            range.Interrupt();
            range.Output.ReadToEnd();
            Assert.That(range.WaitForExit().ExitCode, Is.EqualTo(ExitCodes.Interrupted));
            Assert.That(Directory.GetFiles(folder.Path).Select(Path.GetFileName), Is.EqualTo(new[] { "e.jsonl" }));
            Assert.That(File.ReadLines(folder.File("e.jsonl")).Last(), Does.StartWith("{\"type\":\"end\""));
        }

        [Test]
        [Category("Reference")]
        public void Replay_ReaderThatGoesAway_EndsWithoutAStackTrace()
        {
            using var folder = new TemporaryFolder();
            using var range = new RangeProcess(folder.Path, null, "replay", Recording, "--events", "-");
            Assert.That(range.Output.ReadLine(), Does.StartWith("{\"type\":\"header\""));
            range.Output.Close();
            Assert.That(range.WaitForExit().Error, Is.Empty);
            Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        }

        [Test]
        [Category("Reference")]
        public void Replay_LinkToAPipe_WritesToItAndLeavesTheLink()
        {
            const string standardOutput = "/proc/self/fd/1";
            if (!OperatingSystem.IsLinux())
                Assert.Ignore("only Linux has " + standardOutput);
            using var folder = new TemporaryFolder();
            string link = folder.File("link.jsonl");
            File.CreateSymbolicLink(link, standardOutput);
            using var range = new RangeProcess(folder.Path, null, "replay", Recording, "--events", link);
            Assert.That(range.Output.ReadToEnd(), Does.Contain("{\"type\":\"end\""));
            Assert.That(range.WaitForExit().ExitCode, Is.EqualTo(ExitCodes.Done));
            Assert.That(new FileInfo(link).LinkTarget, Is.EqualTo(standardOutput));
            Assert.That(Directory.GetFiles(folder.Path), Has.Length.EqualTo(1));
        }

        [Test]
        [Category("Reference")]
        public void Replay_Repeated_WritesTheSameBytes()
        {
            using var folder = new TemporaryFolder();
            string[] names = { "a", "b", "c", "d" };
            string?[] switches = { null, null, "DOTNET_EnableAVX2", "DOTNET_EnableHWIntrinsic" };
            string[] results = names.Zip(switches, (name, runtimeSwitch) => Replay(folder, name, runtimeSwitch)).ToArray();
            Assert.That(results[0], Does.Contain("\"type\":\"shot\""));
            foreach (string result in results)
                Assert.That(result == results[0], Is.True, "events differ");
            string[] dots = names.Select(name => WithoutWallTime(folder.File(name + ".dots"))).ToArray();
            Assert.That(dots, Is.All.EqualTo(dots[0]));
        }

        private static string Recording => TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv");

        private static string Replay(TemporaryFolder folder, string name, string? runtimeSwitch)
        {
            using var range = new RangeProcess(folder.Path, runtimeSwitch, "replay", Recording, "--events", name, "--dots", name + ".dots");
            range.Output.ReadToEnd();
            Assert.That(range.WaitForExit().ExitCode, Is.EqualTo(ExitCodes.Done));
            return WithoutWallTime(folder.File(name));
        }

        private static string WithoutWallTime(string path) => Regex.Replace(File.ReadAllText(path), "\"seconds_wall\":[0-9.e-]+", string.Empty);

        private static void WaitFor(Func<bool> condition) =>
            Assert.That(SpinWait.SpinUntil(() => condition() || !Sleep(), 20_000), Is.True, "it did not begin");

        private static bool Sleep()
        {
            Thread.Sleep(10);
            return true;
        }
    }
}
