using System;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host
{
    /// <summary>Programs outside .NET: whether they are there, which command brings them, and installing them where that was asked for.</summary>
    internal static class Prerequisites
    {
        /// <summary>Full path of a program on PATH, or null.</summary>
        public static string? Locate(string program)
        {
            string name = OperatingSystem.IsWindows() ? program + ".exe" : program;
            return (Environment.GetEnvironmentVariable("PATH") ?? string.Empty)
                .Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries)
                .Select(folder => Path.Combine(folder, name))
                .FirstOrDefault(File.Exists);
        }

        /// <summary>The command that installs a program on this system.</summary>
        public static string InstallCommand(string program) =>
            OperatingSystem.IsWindows() ? "winget install " + program
            : OperatingSystem.IsMacOS() ? "brew install " + program
            : "apt-get install " + program;

        /// <summary>Installs a missing program when RANGE_INSTALL=1 is set; says so on standard error. Otherwise does nothing.</summary>
        public static void InstallIfAsked(string program)
        {
            if (Environment.GetEnvironmentVariable("RANGE_INSTALL") != "1" || Locate("apt-get") == null || Locate(program) != null)
                return;
            Console.Error.WriteLine($"installing {program} …");
            ChildProcess.Run("apt-get", new[] { "update", "-q" }, null, CancellationToken.None);
            var result = ChildProcess.Run("apt-get", new[] { "install", "-y", "-q", "--no-install-recommends", program }, null, CancellationToken.None);
            if (result.ExitCode != 0)
                Console.Error.WriteLine($"range: {program} could not be installed; tests that need it are skipped");
        }
    }
}
