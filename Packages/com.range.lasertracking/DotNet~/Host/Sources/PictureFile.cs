using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>Single pictures by name, and lists of them by pattern.</summary>
    internal sealed class PictureFile : IDisposable
    {
        private readonly JpegDecoder _jpeg = new();
        private readonly Frame _frame = new();

        /// <summary>Files that the patterns mean, in the order of their numbers: names, folders, or names with * and ?.</summary>
        /// <exception cref="InputException">A pattern means no picture.</exception>
        public static List<string> Expand(IEnumerable<string> patterns, string option)
        {
            var files = new List<string>();
            foreach (string pattern in patterns)
            {
                int before = files.Count;
                string folder = Path.GetDirectoryName(pattern) is { Length: > 0 } parent ? parent : ".", name = Path.GetFileName(pattern);
                if (Directory.Exists(pattern))
                    files.AddRange(Directory.GetFiles(pattern).Where(ImageFolder.IsImage));
                else if (File.Exists(pattern))
                    files.Add(pattern);
                else if (Directory.Exists(folder) && name.AsSpan().IndexOfAny('*', '?') >= 0)
                    files.AddRange(Directory.GetFiles(folder, name).Where(ImageFolder.IsImage));
                if (files.Count == before)
                    throw new InputException(option, $"\"{pattern}\" means no picture", "name pictures, a folder, or a pattern in quotes like \"left*.png\"");
            }

            return files.Distinct().Select(file => (File: file, Number: ImageFolder.LastNumber(Path.GetFileNameWithoutExtension(file), out string stem), Stem: stem))
                .OrderBy(file => file.Stem, StringComparer.Ordinal).ThenBy(file => file.Number).ThenBy(file => file.File, StringComparer.Ordinal).Select(file => file.File).ToList();
        }

        /// <summary>Width and height without decoding where the format allows; null when the file is no picture.</summary>
        public (int Width, int Height)? TryReadSize(string path)
        {
            if (!File.Exists(path) || !ImageFolder.IsImage(path))
                return null;
            if (ImageFileHeader.TryReadSize(path, out int width, out int height))
                return (width, height);
            Image image = Read(path);
            return (image.Width, image.Height);
        }

        /// <summary>The picture, valid until the next one is read. JPEG by the product's own decoder, all else through ffmpeg.</summary>
        /// <exception cref="InputException">It cannot be read.</exception>
        public Image Read(string path)
        {
            if (!File.Exists(path))
                throw new InputException(path, Directory.Exists(path) ? "this is a folder" : "no such file", "name a picture");
            string problem = string.Empty;
            if (Path.GetExtension(path).ToLowerInvariant() is ".jpg" or ".jpeg")
            {
                try
                {
                    if (_jpeg.TryDecode(File.ReadAllBytes(path), _frame.Color, 0, out problem))
                        return _frame.Color;
                }
                catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
                {
                    throw new InputException(path, "cannot be read (" + exception.Message.ReplaceLineEndings(" ").TrimEnd('.') + ")", "check its permissions");
                }

                if (!problem.Contains("not supported", StringComparison.Ordinal))
                    throw new InputException(path, problem, "take or copy the picture again");
            }

            using var source = new VideoSource(path);
            return source.TryRead(_frame) && _frame.Color.IsPresent ? _frame.Color : throw new InputException(path, "cannot be decoded", "take or copy the picture again");
        }

        public void Dispose()
        {
            _frame.Dispose();
        }
    }
}
