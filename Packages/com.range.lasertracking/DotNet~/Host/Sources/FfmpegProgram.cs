using System;
using System.Collections.Concurrent;
using System.Diagnostics;

namespace LaserTracking.Host.Sources
{
    /// <summary>Programs outside .NET that reading videos needs.</summary>
    internal static class FfmpegProgram
    {
        private static readonly ConcurrentDictionary<string, bool> KnowsFrameRateMode = new();

        /// <summary>Full path of ffmpeg or ffprobe, which is needed to read <paramref name="source"/>.</summary>
        /// <exception cref="InputException">It is not installed; the message names the command that installs it.</exception>
        public static string Require(string program, string source)
        {
            if (Prerequisites.Locate(program) == null)
                Prerequisites.InstallIfAsked("ffmpeg");
            return Prerequisites.Locate(program) ?? throw new InputException(
                source, $"reading this needs the program {program}, which is not on PATH", "install it with: " + Prerequisites.InstallCommand("ffmpeg"));
        }

        /// <summary>The option that keeps every frame as it is, which was renamed in ffmpeg 5.1.</summary>
        public static string PassthroughOption(string ffmpeg) => KnowsFrameRateMode.GetOrAdd(ffmpeg, AsksForFrameRateMode) ? "-fps_mode" : "-vsync";

        private static bool AsksForFrameRateMode(string ffmpeg)
        {
            var start = new ProcessStartInfo(ffmpeg) { RedirectStandardOutput = true, CreateNoWindow = true, ArgumentList = { "-version" } };
            using Process process = Process.Start(start) ?? throw new InvalidOperationException("ffmpeg did not start");
            string[] words = process.StandardOutput.ReadToEnd().Split(' ', 4);
            process.WaitForExit();

            // "ffmpeg version 4.4.2-0ubuntu0.22.04.1 Copyright…"; builds between releases have no such number and are young.
            string[] numbers = words.Length > 2 ? words[2].Split('.', '-', '+') : [];
            if (numbers.Length < 2 || !int.TryParse(numbers[0], out int major))
                return true;
            return major > 5 || (major == 5 && numbers[1] != "0");
        }
    }
}
