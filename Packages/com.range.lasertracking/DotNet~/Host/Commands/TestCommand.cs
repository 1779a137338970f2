using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using System.Xml.Linq;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Commands
{
    /// <summary>range test [--reference]: every automated test, against both builds of Core, with and without vector instructions.</summary>
    internal static class TestCommand
    {
        private const string Reference = "TestCategory=Reference";

        /// <summary>
        /// What takes seconds runs once, in the build that Unity takes: that every form of a kernel gives the same bits, and that each allocates
        /// nothing, shorter tests say.
        /// </summary>
        private const string Short = "TestCategory!=Long";

        /// <summary>Each keeps one core busy.</summary>
        private const int SuitesAtOnce = 2;

        /// <summary>The longest first: beside it the others take their turns.</summary>
        private static readonly Suite[] Suites =
        {
            new("files, commands, repository", "RangeTests", null),
            new("Core, netstandard2.1", "Range.LaserTracking.Core.Tests.NetStandard", null),
            new("Core, net10.0, no vector instructions", "Range.LaserTracking.Core.Tests", "DOTNET_EnableHWIntrinsic", Short),
            new("Core, net10.0", "Range.LaserTracking.Core.Tests", null, Short),
            new("Core, net10.0, no AVX2", "Range.LaserTracking.Core.Tests", "DOTNET_EnableAVX2", Short),
            new("Unity layer on the engine stand-in", "UnityTests", null),
            new("Burst jobs on the engine stand-in", "BurstTests", null),
        };

        public static Command Create()
        {
            var reference = new Option<bool>("--reference") { Description = "Only the tests that compare with reference files (folder: RANGE_DATA, default ../shared/data)." };
            var filter = new Option<string?>("--filter") { HelpName = "TEXT", Description = "Only tests whose full name holds this text." };
            var command = new Command("test", "Runs every automated test; the last line says how many passed, failed and were skipped.") { reference, filter };
            command.SetAction((parsed, interrupted) => Task.FromResult(Run(parsed.GetValue(reference), parsed.GetValue(filter), interrupted)));
            return command;
        }

        private static int Run(bool referenceOnly, string? nameFilter, CancellationToken interrupted)
        {
            string root = RepositoryFolder.Find();
            Prerequisites.InstallIfAsked("ffmpeg");
            using var progress = new ProgressLine();
            progress.Show("building the tests …");
            Build(root, interrupted);

            string results = Path.Combine(root, ".artifacts", "test-results");
            if (Directory.Exists(results))
                Directory.Delete(results, true);
            var total = new Counts(0, 0, 0);
            using var turns = new SemaphoreSlim(SuitesAtOnce);
            var running = Suites.Where(s => !referenceOnly || s.Project == "RangeTests")
                .Select(suite => (suite.Name, Counts: Task.Run(() => InTurn(turns, () => RunSuite(root, results, suite, referenceOnly, nameFilter, interrupted))))).ToArray();
            foreach ((string name, Task<Counts> counts) in running)
            {
                progress.Show("testing: " + name + " …");
                Counts found = counts.GetAwaiter().GetResult();
                progress.Clear();
                Console.WriteLine($"{name}: {found}");
                total += found;
            }

            Console.WriteLine(total.ToString());
            return total.Failed > 0 || total.Passed == 0 ? ExitCodes.CheckFailed : ExitCodes.Done;
        }

        private static Counts InTurn(SemaphoreSlim turns, Func<Counts> run)
        {
            turns.Wait();
            try
            {
                return run();
            }
            finally
            {
                turns.Release();
            }
        }

        private static void Build(string root, CancellationToken interrupted)
        {
            string solution = Path.Combine(root, "Packages", "com.range.lasertracking", "DotNet~", "Range.LaserTracking.slnx");
            var result = ChildProcess.Run("dotnet", new[] { "build", solution, "-c", "Release", "-v", "q", "--nologo" }, null, interrupted);
            if (result.ExitCode == 0)
                return;
            string first = result.Output.Split('\n').FirstOrDefault(l => l.Contains("error", StringComparison.Ordinal)) ?? result.Output.TrimEnd().Split('\n')[^1];
            throw new InputException("test", "the tests do not build: " + first.Trim(), "fix that and run again");
        }

        private static Counts RunSuite(string root, string results, Suite suite, bool referenceOnly, string? nameFilter, CancellationToken interrupted)
        {
            string assembly = Path.Combine(root, ".artifacts", "bin", suite.Project, "release", suite.Project + ".dll");
            string log = Path.Combine(results, suite.Project + (suite.SwitchedOff ?? string.Empty) + ".trx");
            var arguments = new List<string> { "test", assembly, "--logger", "trx;LogFileName=" + log };
            string filter = string.Join("&", new[] { suite.Filter, referenceOnly ? Reference : null, nameFilter == null ? null : "FullyQualifiedName~" + nameFilter }.Where(f => f != null));
            if (filter.Length > 0)
                arguments.AddRange(new[] { "--filter", filter });
            var environment = suite.SwitchedOff == null ? null : new Dictionary<string, string> { [suite.SwitchedOff] = "0" };
            var result = ChildProcess.Run("dotnet", arguments, environment, interrupted);
            if (!File.Exists(log))
            {
                if (filter.Length > 0 && result.ExitCode == 0)
                    return new Counts(0, 0, 0);
                Console.Error.WriteLine(result.Output);
                throw new InputException(suite.Project, "the test run ended without a result", "see the lines above");
            }

            return ReadResults(log, suite);
        }

        private static Counts ReadResults(string log, Suite suite)
        {
            int passed = 0, failed = 0, skipped = 0;
            foreach (XElement result in XDocument.Load(log).Descendants().Where(e => e.Name.LocalName == "UnitTestResult"))
            {
                switch ((string?)result.Attribute("outcome"))
                {
                    case "Passed":
                        passed++;
                        break;
                    case "Failed":
                        failed++;
                        string message = result.Descendants().FirstOrDefault(e => e.Name.LocalName == "Message")?.Value ?? string.Empty;
                        Console.WriteLine($"FAILED ({suite.Name}) {(string?)result.Attribute("testName")}: {message.Trim()}");
                        break;
                    default:
                        skipped++;
                        break;
                }
            }

            return new Counts(passed, failed, skipped);
        }

        private sealed record Suite(string Name, string Project, string? SwitchedOff, string? Filter = null);

        private sealed record Counts(int Passed, int Failed, int Skipped)
        {
            public static Counts operator +(Counts a, Counts b) => new(a.Passed + b.Passed, a.Failed + b.Failed, a.Skipped + b.Skipped);

            public override string ToString() => FormattableString.Invariant($"{Passed} passed, {Failed} failed, {Skipped} skipped");
        }
    }
}
