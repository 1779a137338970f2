using System;
using System.IO;

namespace LaserTracking.Host.Sessions
{
    /// <summary>A result that appears under its name only when it is whole: written beside it, moved at the end, deleted otherwise.</summary>
    internal sealed class ResultFile : IDisposable
    {
        private readonly string? _path;
        private readonly string? _temporary;

        /// <param name="path">"-" is standard output, which cannot be taken back.</param>
        public ResultFile(string path)
        {
            if (path == "-")
            {
                Stream = Console.OpenStandardOutput();
                return;
            }

            string? folder = Path.GetDirectoryName(Path.GetFullPath(path));
            if (Directory.Exists(path))
                throw new InputException(path, "this is a folder", "name a file to write");
            Directory.CreateDirectory(folder!);
            _path = path;
            _temporary = path + ".part";
            Stream = new FileStream(_temporary, FileMode.Create, FileAccess.Write, FileShare.Read, 1 << 16);
        }

        public Stream Stream { get; }

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
            Stream.Dispose();
            if (_temporary != null)
                File.Delete(_temporary);
        }
    }
}
