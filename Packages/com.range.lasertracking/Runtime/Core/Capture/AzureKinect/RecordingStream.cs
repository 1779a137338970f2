using System;
using System.IO;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Opens a file for random access and turns every way that can fail into a line that helps.</summary>
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
    }
}
