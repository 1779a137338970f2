using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Host.Benchmarks;
using LaserTracking.Host.Terminal;
using Newtonsoft.Json;

namespace LaserTracking.Host.Commands
{
    /// <summary>range bench [NAME…] [--json] [--peer]: times each stage on fixed synthetic work.</summary>
    internal static class BenchCommand
    {
        public static Command Create()
        {
            var names = new Argument<string[]>("NAME") { Description = "Benchmarks to run; all when left out. Known: " + string.Join(", ", BenchmarkList.All.Select(b => b.Name)) + ".", Arity = ArgumentArity.ZeroOrMore };
            var json = new Option<bool>("--json") { Description = "Prints JSON instead of a table." };
            var peer = new Option<bool>("--peer") { Description = "Times the published algorithms written with OpenCV on the same frames too; needs python3 with cv2." };
            var command = new Command("bench", "Times each stage on fixed synthetic work, one thread.") { names, json, peer };
            command.SetAction((parsed, interrupted) =>
                Task.FromResult(Run(parsed.GetValue(names) ?? Array.Empty<string>(), parsed.GetValue(json), parsed.GetValue(peer), interrupted)));
            return command;
        }

        private static int Run(string[] names, bool asJson, bool withPeer, CancellationToken interrupted)
        {
            IReadOnlyList<Benchmark> all = BenchmarkList.All;
            foreach (string name in names)
            {
                if (all.All(b => b.Name != name))
                    throw new InputException(name, "there is no such benchmark", "known are " + string.Join(", ", all.Select(b => b.Name)));
            }

            var results = new List<BenchmarkResult>();
            IReadOnlyList<PeerResult>? peer = null;
            string missing = string.Empty;
            using (var progress = new ProgressLine())
            {
                foreach (Benchmark benchmark in all.Where(b => names.Length == 0 || names.Contains(b.Name)))
                {
                    string needed = benchmark.Missing();
                    if (needed.Length > 0)
                    {
                        progress.Clear();
                        Console.Error.WriteLine($"range: {benchmark.Name} is left out: {needed}");
                        continue;
                    }

                    progress.Show("timing " + benchmark.Name + " …");
                    results.Add(benchmark.Run(interrupted));
                }

                if (withPeer)
                {
                    progress.Show("timing the OpenCV peer …");
                    peer = PeerRun.TryRun(results, interrupted, out missing);
                }
            }

            if (asJson)
                Console.WriteLine(JsonConvert.SerializeObject(new { cpu = ProcessorName(), threads = 1, results, peer }, Formatting.Indented));
            else
                Print(results, peer);
            if (missing.Length > 0)
                Console.Error.WriteLine("range: --peer: " + missing);
            return ExitCodes.Done;
        }

        private static void Print(List<BenchmarkResult> results, IReadOnlyList<PeerResult>? peer)
        {
            Console.WriteLine(ProcessorName() + ", one thread");
            Console.WriteLine($"{"name",-20} {"median ms",10} {"p95 ms",10} {"bytes/op",9}  what");
            foreach (BenchmarkResult r in results)
                Console.WriteLine(FormattableString.Invariant($"{r.Name,-20} {r.MedianMs,10:F4} {r.P95Ms,10:F4} {r.AllocatedBytesPerOperation,9}  {r.What}"));
            foreach (PeerResult r in peer ?? Array.Empty<PeerResult>())
            {
                string ratios = string.Join(", ", r.Ratio.Select(pair => FormattableString.Invariant($"{pair.Value:F1} × {pair.Key}")));
                Console.WriteLine(FormattableString.Invariant($"{"peer " + r.Name,-20} {r.MedianMs,10:F4} {r.P95Ms,10:F4} {"",9}  OpenCV, {r.Variant}: {ratios}"));
            }
        }

        private static string ProcessorName()
        {
            const string source = "/proc/cpuinfo";
            string? line = File.Exists(source) ? File.ReadLines(source).FirstOrDefault(l => l.StartsWith("model name", StringComparison.Ordinal)) : null;
            return line?[(line.IndexOf(':') + 1)..].Trim() ?? System.Runtime.InteropServices.RuntimeInformation.ProcessArchitecture.ToString();
        }
    }
}
