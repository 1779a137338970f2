using System;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using LaserTracking.Host.Commands;

namespace LaserTracking.Host
{
    /// <summary>The program behind ./range: parses the line, runs one command, turns what went wrong into one line and an exit code.</summary>
    internal static class Program
    {
        private static int Main(string[] args)
        {
            using var interrupt = new CancellationTokenSource();

            // The first Ctrl-C ends the work in order; a second one ends the program, should it hang.
            void Stop(PosixSignalContext signal)
            {
                signal.Cancel = !interrupt.IsCancellationRequested;
                interrupt.Cancel();
            }

            using PosixSignalRegistration keyboard = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
            using PosixSignalRegistration system = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
            return Run(args, interrupt.Token);
        }

        /// <summary>Runs one command line; returns its exit code. Results go to standard output, everything else to standard error.</summary>
        internal static int Run(string[] args, CancellationToken interrupted)
        {
            RootCommand root = RangeCommands.Create();
            if (args.Length == 0)
                args = new[] { "help" };
            ParseResult parsed = root.Parse(args);
            if (parsed.Errors.Count > 0 && !parsed.Tokens.Any(t => t.Value is "--help" or "-h" or "-?"))
                return Fail(UsageProblem.Describe(parsed));

            try
            {
                var configuration = new InvocationConfiguration { EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null };
                int exitCode = parsed.InvokeAsync(configuration, interrupted).GetAwaiter().GetResult();
                return exitCode == ExitCodes.Interrupted ? Interrupted() : exitCode;
            }
            catch (Exception) when (interrupted.IsCancellationRequested)
            {
                // Also what the decoding programs, ended by the same Ctrl-C, left unfinished.
                return Interrupted();
            }
            catch (InputException problem)
            {
                return Fail(problem.Message);
            }
            catch (UnauthorizedAccessException problem)
            {
                return Fail("files: " + problem.Message.TrimEnd('.') + "; check the permissions");
            }
            catch (IOException problem)
            {
                return Fail("files: " + problem.Message.TrimEnd('.') + "; check the path and the free space");
            }
            catch (Exception problem) when (Environment.GetEnvironmentVariable("RANGE_DEBUG") != "1")
            {
                return Fail($"internal error: {problem.GetType().Name}: {problem.Message.TrimEnd('.')}; please report it (RANGE_DEBUG=1 shows where)");
            }
        }

        private static int Interrupted()
        {
            Console.Error.WriteLine("range: interrupted; what was finished is kept");
            return ExitCodes.Interrupted;
        }

        private static int Fail(string message)
        {
            Console.Error.WriteLine("range: " + message.ReplaceLineEndings(" "));
            return ExitCodes.BadInput;
        }
    }
}
