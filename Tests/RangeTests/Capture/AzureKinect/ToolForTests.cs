using System;
using System.Diagnostics;
using System.Threading.Tasks;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Other people's programs that read Matroska, as second opinions; a test is skipped where one is not installed.</summary>
    internal static class ToolForTests
    {
        /// <summary>Everything it said, standard error first.</summary>
        public static (int ExitCode, string Output, string Error) Run(string program, params string[] arguments)
        {
            string? path = Prerequisites.Locate(program);
            if (path == null)
                Assert.Ignore(program + " is not installed");
            var start = new ProcessStartInfo(path!, arguments) { RedirectStandardOutput = true, RedirectStandardError = true };
            using Process process = Process.Start(start)!;
            Task<string> error = process.StandardError.ReadToEndAsync();
            string output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            return (process.ExitCode, output, error.Result);
        }
    }
}
