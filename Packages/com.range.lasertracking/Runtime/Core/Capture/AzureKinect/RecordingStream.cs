using System;
using System.IO;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Opens recordings for random access, creates new ones, and turns every way that can fail into a line that helps.</summary>
    internal static class RecordingStream
    {
        public static Stream Open(string path)
        {
            try
            {
                if (Directory.Exists(path))
                    throw new InputException(path, "is a folder, not a recording", "give the .mkv file in it");
                if (!File.Exists(path))
                    throw new InputException(path, "no such file", "check the name");

                // Its own buffer would only copy twice: small reads go through the reader's pages, large ones straight to their place.
                return new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite, 1, FileOptions.RandomAccess);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException
                || exception is ArgumentException || exception is NotSupportedException)
            {
                throw new InputException(path, "cannot be opened (" + exception.Message.Replace('\n', ' ').Replace('\r', ' ') + ")",
                    "check that it may be read and that no other program holds it");
            }
        }

        /// <summary>A new file for a recording, without a buffer of its own: what is written is in the system's hands. Makes the folder.</summary>
        /// <exception cref="InputException">It exists, or cannot be written.</exception>
        public static FileStream Create(string path)
        {
            const string Remedy = "name a file in a folder that can be written to";
            try
            {
                if (path.Length == 0 || Directory.Exists(path))
                    throw new InputException(path.Length == 0 ? "\"\"" : path, "this is no name for a recording", Remedy);
                if (File.Exists(path))
                    throw new InputException(path, "exists already and is not overwritten", "name another file, or delete this one");
                Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
                return new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.ReadWrite, 1);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException
                || exception is ArgumentException || exception is NotSupportedException)
            {
                throw new InputException(path, "cannot be written (" + exception.Message.Replace('\n', ' ').Replace("\r", "").TrimEnd('.') + ")", Remedy);
            }
        }
    }
}
