using System;
using System.IO;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Sessions
{
    /// <summary>
    /// A result that appears under its name only when it is whole: written beside it, moved at the end, deleted otherwise. Two runs
    /// cannot write the same result at once.
    /// </summary>
    internal sealed class ResultFile : IDisposable
    {
        private const int MaximumLinks = 40;

        private readonly string? _path;
        private readonly string? _temporary;

        /// <param name="path">"-" is standard output, which cannot be taken back.</param>
        /// <exception cref="InputException">It cannot be written.</exception>
        public ResultFile(string path)
        {
            if (path == "-")
            {
                Stream = Console.OpenStandardOutput();
                return;
            }

            if (path.Length == 0 || Directory.Exists(path))
                throw new InputException(path.Length == 0 ? "\"\"" : path, "this is no name for a file", "name a file to write");
            try
            {
                // A link stays a link: what it points to is replaced.
                string target = Path.GetFullPath(path);
                for (int links = 0; !IsDevice(target) && new FileInfo(target).LinkTarget != null && links < MaximumLinks; links++)
                    target = File.ResolveLinkTarget(target, returnFinalTarget: false)!.FullName;
                if (IsDevice(target))
                {
                    Stream = new FileStream(target, FileMode.Open, FileAccess.Write);
                    return;
                }

                _path = target;
                _temporary = _path + ".part";
                Directory.CreateDirectory(Path.GetDirectoryName(_path)!);

                // Only without sharing does .NET lock a file that it writes.
                Stream = new FileStream(_temporary, FileMode.Create, FileAccess.Write, FileShare.None, 1 << 16);
            }
            catch (Exception problem) when (problem is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
            {
                string? file = FileInPlaceOfFolder(path);
                throw new InputException(path, file != null ? $"cannot be written: {file} is a file, not a folder" : "cannot be written (" + problem.Message.ReplaceLineEndings(" ").TrimEnd('.') + ")",
                    "name a place that can be written and that no other run is writing to");
            }
        }

        public Stream Stream { get; }

        /// <exception cref="InputException">The result would take the place of something that is read.</exception>
        public static void CheckNotRead(string? result, params ReadOnlySpan<string?> inputs)
        {
            foreach (string? input in inputs)
            {
                if (string.IsNullOrEmpty(result) || string.IsNullOrEmpty(input))
                    continue;
                string written = Path.GetFullPath(result), read = Path.GetFullPath(input);
                bool isOneOfItsPictures = File.Exists(written) && ImageFolder.IsImage(written) && Path.GetDirectoryName(written) == Path.TrimEndingDirectorySeparator(read);
                if (written == read || isOneOfItsPictures)
                    throw new InputException(result, "this file is also read", "give the result another name");
            }
        }

        /// <summary>The result is whole: give it its name.</summary>
        public void Commit()
        {
            Stream.Flush();
            if (_path == null)
                return;
            Stream.Dispose();
            File.Move(_temporary!, _path, true);
        }

        public void Dispose()
        {
            try
            {
                Stream.Dispose();
            }
            catch (IOException)
            {
                // The disk is full: the error that led here says so.
            }

            if (_temporary != null)
                File.Delete(_temporary);
        }

        private static string? FileInPlaceOfFolder(string path)
        {
            string? folder = Path.GetDirectoryName(path);
            while (!string.IsNullOrEmpty(folder) && !File.Exists(folder))
                folder = Path.GetDirectoryName(folder);
            return string.IsNullOrEmpty(folder) ? null : folder;
        }

        /// <summary>Devices and pipes are written to; a file moved on to one would take its place.</summary>
        private static bool IsDevice(string path) =>
            !OperatingSystem.IsWindows() && File.Exists(path) && (path.StartsWith("/dev/", StringComparison.Ordinal) || path.StartsWith("/proc/", StringComparison.Ordinal))
            && !path.StartsWith("/dev/shm/", StringComparison.Ordinal);
    }
}
