using System;
using System.IO;
using System.Text.RegularExpressions;
using System.Threading;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>Runs one command line within the test, as ./range would, and checks what every refusal has in common.</summary>
    internal static partial class CommandLine
    {
        public static (int ExitCode, string Output, string Error) Run(params string[] arguments)
        {
            TextWriter output = Console.Out, error = Console.Error;
            using var newOutput = new StringWriter();
            using var newError = new StringWriter();
            Console.SetOut(newOutput);
            Console.SetError(newError);
            try
            {
                int exitCode = Program.Run(arguments, CancellationToken.None);
                return (exitCode, newOutput.ToString(), newError.ToString());
            }
            finally
            {
                Console.SetOut(output);
                Console.SetError(error);
            }
        }

        /// <summary>Exit code 2, nothing on standard output, one line "range: WHERE: what; remedy" that holds the words. Returns the line.</summary>
        public static string AssertRefused(string words, params string[] arguments)
        {
            (int exitCode, string output, string error) = Run(arguments);
            string line = error.TrimEnd('\r', '\n');
            Assert.That(exitCode, Is.EqualTo(ExitCodes.BadInput), error);
            Assert.That(output, Is.Empty);
            Assert.That(line, Does.Match(OneLine().ToString()));
            Assert.That(line, Does.Contain(words));
            Assert.That(line, Does.Not.Contain("internal error").And.Not.Contain("System."));
            return line;
        }

        [GeneratedRegex(@"^range: [^\n]+: [^\n]+; [^\n]+$")]
        private static partial Regex OneLine();
    }
}
