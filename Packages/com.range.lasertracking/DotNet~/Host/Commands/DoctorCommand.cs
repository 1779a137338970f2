using System;
using System.CommandLine;
using System.Diagnostics;
using System.IO;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics.X86;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;

namespace LaserTracking.Host.Commands
{
    /// <summary>range doctor: what is installed, disk, clock; each problem with the one thing to do.</summary>
    internal static class DoctorCommand
    {
        private const long MinimumFreeBytes = 2L << 30;

        public static Command Create()
        {
            var command = new Command("doctor", "Says what is installed and what is missing; each problem with the one thing to do.");
            command.SetAction(_ => Run());
            return command;
        }

        private static int Run()
        {
            Report(true, ".NET", RuntimeInformation.FrameworkDescription + ", " + RuntimeInformation.RuntimeIdentifier, string.Empty);
            Report(true, "processor", $"{Environment.ProcessorCount} threads, AVX2 {(Avx2.IsSupported ? "yes" : "no (slower, same results)")}", string.Empty);
            CheckProgram("ffmpeg", "videos and image folders cannot be read (recordings and the simulation can)");
            foreach (HandModelFile file in HandModelStore.All)
                Report(true, "hand model " + file.Name, File.Exists(HandModelStore.PathOf(file)) ? HandModelStore.PathOf(file) : "not there: hands by depth alone; './range models' fetches it", string.Empty);
            CheckDisk();
            CheckClock();
            Report(true, "cameras", "live cameras are reached from Unity; this program reads recordings, videos, pictures and the simulated range", string.Empty);
            return ExitCodes.Done;
        }

        private static void CheckProgram(string program, string consequence)
        {
            string? path = Prerequisites.Locate(program);
            Report(path != null, program, path ?? "not found: " + consequence, Prerequisites.InstallCommand(program));
        }

        private static void CheckDisk()
        {
            var drive = new DriveInfo(Path.GetFullPath("."));
            double free = drive.AvailableFreeSpace / (double)(1L << 30);
            Report(drive.AvailableFreeSpace >= MinimumFreeBytes, "disk", FormattableString.Invariant($"{free:F1} GiB free here"), "free some space before recording");
        }

        private static void CheckClock()
        {
            bool precise = Stopwatch.IsHighResolution;
            double tickNs = 1e9 / Stopwatch.Frequency;
            Report(precise, "clock", FormattableString.Invariant($"ticks of {tickNs:F0} ns"), "latency figures will be coarse on this machine");
        }

        private static void Report(bool ok, string what, string found, string remedy) =>
            Console.WriteLine((ok ? "ok       " : "PROBLEM  ") + what + ": " + found + (ok ? string.Empty : "; " + remedy));
    }
}
