using System;
using System.IO;

namespace LaserTracking.Host.Sources;

/// <summary>Programs outside .NET that the host makes use of.</summary>
public static class Tools
{
    /// <summary>Full path of a program on PATH (on Windows also with .exe), or null.</summary>
    public static string? Find(string name)
    {
        string fileName = OperatingSystem.IsWindows() ? name + ".exe" : name;
        foreach (string folder in (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator))
        {
            if (folder.Length == 0)
                continue;
            string candidate = Path.Combine(folder.Trim('"'), fileName);
            if (File.Exists(candidate))
                return candidate;
        }

        return null;
    }

    /// <summary>Full path of a program that is needed to read <paramref name="source"/>.</summary>
    /// <exception cref="InputException">It is not installed; the message names the command that installs it.</exception>
    public static string Require(string name, string source) =>
        Find(name) ?? throw new InputException(source, $"reading this needs the program {name}, which is not on PATH",
            "install it with: " + InstallCommand("ffmpeg"));

    /// <summary>The command that installs a package on this system.</summary>
    public static string InstallCommand(string package)
    {
        if (OperatingSystem.IsWindows())
            return "winget install " + package;
        return (OperatingSystem.IsMacOS() ? "brew install " : "apt-get install ") + package;
    }
}
