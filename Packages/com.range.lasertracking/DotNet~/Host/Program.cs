using System;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Linq;
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
            Console.CancelKeyPress += (_, press) =>
            {
                press.Cancel = true;
                interrupt.Cancel();
            };
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
            {
                Command command = parsed.CommandResult.Command;
                string what = parsed.Errors[^1].Message.TrimEnd('.');
                return Fail(what + (command == root ? "; './range help' lists the commands" : $"; './range help {command.Name}' shows the usage"));
            }

            try
            {
                var configuration = new InvocationConfiguration { EnableDefaultExceptionHandler = false };
                return parsed.InvokeAsync(configuration, interrupted).GetAwaiter().GetResult();
            }
            catch (OperationCanceledException)
            {
                return ExitCodes.Interrupted;
            }
            catch (InputException problem)
            {
                return Fail(problem.Message);
            }
            catch (UnauthorizedAccessException problem)
            {
                return Fail(problem.Message.TrimEnd('.') + "; check the permissions");
            }
            catch (System.IO.IOException problem)
            {
                return Fail(problem.Message.TrimEnd('.') + "; check the path and the free space");
            }
            catch (Exception problem) when (Environment.GetEnvironmentVariable("RANGE_DEBUG") != "1")
            {
                return Fail($"internal error: {problem.GetType().Name}: {problem.Message}; please report it (RANGE_DEBUG=1 shows where)");
            }
        }

        private static int Fail(string message)
        {
            Console.Error.WriteLine("range: " + message.ReplaceLineEndings(" "));
            return ExitCodes.BadInput;
        }
    }
}
