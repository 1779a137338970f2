using System;
using System.IO;

namespace LaserTracking.Remote
{
    /// <summary>The published exchange between processes: a JSON file that appears under its name only when it is whole.</summary>
    public static class RemoteFile
    {
        /// <summary>
        /// Replaces the file at once: whoever reads sees the old or the new one. One writer a file.
        /// </summary>
        /// <param name="path">In a folder that exists.</param>
        /// <param name="content">UTF-8, one message a line, or nothing.</param>
        /// <exception cref="InputException">It cannot be written.</exception>
        public static void Write(string path, ReadOnlySpan<byte> content)
        {
            string temporary = path + ".part";
            try
            {
                using (var stream = new FileStream(temporary, FileMode.Create, FileAccess.Write, FileShare.None, 1))
                    stream.Write(content);
                if (File.Exists(path))
                    File.Replace(temporary, path, null);
                else
                    File.Move(temporary, path);
            }
            catch (Exception e) when (IsFileProblem(e))
            {
                throw new InputException(path, "cannot be written", "check folder, rights and disk");
            }
        }

        /// <exception cref="InputException">No file can have this name, or it is a folder.</exception>
        internal static void CheckName(string path)
        {
            bool isName;
            try
            {
                isName = Path.GetFileName(new FileInfo(path).FullName).Length > 0 && !Directory.Exists(path);
            }
            catch (Exception e) when (IsFileProblem(e))
            {
                isName = false;
            }

            if (!isName)
                throw new InputException(path.Length == 0 ? "\"\"" : path, "this is no name for a file", "name the file that the detector writes");
        }

        /// <summary>The whole content, or false: not there, not to be opened now, longer than the buffer, or changed while it was read.</summary>
        internal static bool TryRead(string path, byte[] buffer, out int length)
        {
            length = 0;
            try
            {
                using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, 1);
                long size = stream.Length;
                for (int read = 1; read > 0 && length < buffer.Length; length += read)
                    read = stream.Read(buffer, length, buffer.Length - length);
                return length == size && stream.Length == size && size < buffer.Length;
            }
            catch (Exception e) when (IsFileProblem(e))
            {
                return false;
            }
        }

        private static bool IsFileProblem(Exception e) =>
            e is IOException || e is UnauthorizedAccessException || e is ArgumentException || e is NotSupportedException;
    }
}
