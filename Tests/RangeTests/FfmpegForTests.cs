using System;
using System.Diagnostics;
using System.IO;
using LaserTracking.Host;
using NUnit.Framework;

namespace LaserTracking
{
    /// <summary>Runs FFmpeg to make inputs and second opinions; a test that needs it is skipped where it is not installed.</summary>
    internal static class FfmpegForTests
    {
        /// <summary>What the program wrote to its standard output.</summary>
        public static byte[] Run(params string[] arguments)
        {
            string? program = Prerequisites.Locate("ffmpeg");
            if (program == null)
                Assert.Ignore("ffmpeg is not installed");
            var start = new ProcessStartInfo(program!) { RedirectStandardOutput = true, RedirectStandardError = true };
            foreach (string argument in new[] { "-nostdin", "-v", "error", "-y" })
                start.ArgumentList.Add(argument);
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            using Process process = Process.Start(start)!;
            System.Threading.Tasks.Task<string> errors = process.StandardError.ReadToEndAsync();
            using var output = new MemoryStream();
            process.StandardOutput.BaseStream.CopyTo(output);
            process.WaitForExit();
            if (process.ExitCode != 0)
                throw new InvalidOperationException("ffmpeg failed: " + errors.Result);
            return output.ToArray();
        }
    }
}
