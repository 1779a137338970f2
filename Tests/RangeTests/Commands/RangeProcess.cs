using System;
using System.Diagnostics;
using System.IO;
using System.Threading.Tasks;
using NUnit.Framework;

namespace LaserTracking.Commands
{
    /// <summary>The program as a process of its own, for what only a process has: signals, pipes, switches of the runtime.</summary>
    internal sealed class RangeProcess : IDisposable
    {
        private const int LimitMs = 30_000;

        private readonly Process _process;
        private readonly Task<string> _error;

        /// <param name="folder">Its current folder.</param>
        /// <param name="runtimeSwitch">An environment variable that is set to 0, or null.</param>
        /// <param name="arguments">The command line.</param>
        public RangeProcess(string folder, string? runtimeSwitch, params string[] arguments)
        {
            var start = new ProcessStartInfo("dotnet") { RedirectStandardOutput = true, RedirectStandardError = true, WorkingDirectory = folder };
            start.ArgumentList.Add(Path.Combine(AppContext.BaseDirectory, "range.dll"));
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            if (runtimeSwitch != null)
                start.Environment[runtimeSwitch] = "0";
            _process = Process.Start(start)!;
            _error = _process.StandardError.ReadToEndAsync();
        }

        public StreamReader Output => _process.StandardOutput;

        /// <summary>What Ctrl-C sends.</summary>
        public void Interrupt()
        {
            using Process kill = Process.Start("kill", new[] { "-INT", _process.Id.ToString(System.Globalization.CultureInfo.InvariantCulture) });
            kill.WaitForExit();
        }

        /// <summary>What no program can answer to: SIGKILL.</summary>
        public void Kill()
        {
            _process.Kill();
            _process.WaitForExit();
        }

        public (int ExitCode, string Error) WaitForExit()
        {
            Assert.That(_process.WaitForExit(LimitMs), Is.True, "the program hangs");
            return (_process.ExitCode, _error.Result);
        }

        public void Dispose()
        {
            if (!_process.HasExited)
                _process.Kill();
            _process.Dispose();
        }
    }
}
