using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Text;
using System.Threading;

namespace LaserTracking.Host.Terminal
{
    /// <summary>Runs another program to its end and returns what it printed.</summary>
    internal static class ChildProcess
    {
        /// <summary>Standard output and standard error in one text, in order of arrival. Cancellation ends the whole process tree.</summary>
        public static (int ExitCode, string Output) Run(string program, IEnumerable<string> arguments,
            IReadOnlyDictionary<string, string>? environment, CancellationToken interrupted)
        {
            var start = new ProcessStartInfo(program) { RedirectStandardOutput = true, RedirectStandardError = true, UseShellExecute = false };
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
            if (environment != null)
            {
                foreach ((string name, string value) in environment)
                    start.Environment[name] = value;
            }

            var output = new StringBuilder();
            using var process = new Process { StartInfo = start };
            void Append(object sender, DataReceivedEventArgs line)
            {
                lock (output)
                    output.AppendLine(line.Data);
            }

            process.OutputDataReceived += Append;
            process.ErrorDataReceived += Append;
            process.Start();
            process.BeginOutputReadLine();
            process.BeginErrorReadLine();
            using (interrupted.Register(() => End(process)))
                process.WaitForExit();
            interrupted.ThrowIfCancellationRequested();
            return (process.ExitCode, output.ToString());
        }

        private static void End(Process process)
        {
            try
            {
                process.Kill(entireProcessTree: true);
            }
            catch (Exception problem) when (problem is InvalidOperationException or AggregateException or System.ComponentModel.Win32Exception)
            {
                // It, or a part of it, ended by itself in between.
            }
        }
    }
}
