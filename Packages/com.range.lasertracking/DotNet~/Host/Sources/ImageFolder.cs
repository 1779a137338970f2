using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>
    /// The pictures of a folder in order, with their times: those of the colour track in a frames.jsonl beside them (as `extract` writes
    /// it), else evenly spaced.
    /// </summary>
    internal sealed class ImageFolder
    {
        private const string FrameList = "frames.jsonl";

        private static readonly string[] Extensions =
            [".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm", ".ppm", ".pnm", ".pbm", ".pam"];

        private readonly List<ImageFolderEntry> _entries = new();
        private readonly List<FrameProblem> _problems = new();

        private ImageFolder(string path) => Path = path;

        public string Path { get; }

        public IReadOnlyList<ImageFolderEntry> Entries => _entries;

        /// <summary>Numbers that are missing, lines of frames.jsonl that say nothing.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems;

        /// <summary>True when the times come from frames.jsonl.</summary>
        public bool HasTimes { get; private set; }

        public static bool IsImage(string path) => Extensions.Contains(System.IO.Path.GetExtension(path).ToLowerInvariant());

        /// <param name="path">The folder.</param>
        /// <param name="framesPerSecond">Spacing of the pictures where nothing else tells their times.</param>
        /// <exception cref="InputException">There is no picture in it, or it cannot be read.</exception>
        public static ImageFolder Open(string path, double framesPerSecond)
        {
            if (!(framesPerSecond > 0) || double.IsInfinity(framesPerSecond))
                throw new ArgumentOutOfRangeException(nameof(framesPerSecond), "above 0");
            var folder = new ImageFolder(path);
            try
            {
                string list = System.IO.Path.Combine(path, FrameList);
                if (File.Exists(list))
                    folder.ReadFrameList(list);
                if (folder._entries.Count == 0)
                    folder.ReadFiles(framesPerSecond);
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read (" + exception.Message.ReplaceLineEndings(" ") + ")", "check its permissions");
            }

            if (folder._entries.Count == 0)
                throw new InputException(path, "is a folder without pictures", "give a folder of numbered png, jpg, bmp, tif or pgm files, or a recording");
            return folder;
        }

        private void ReadFiles(double framesPerSecond)
        {
            var files = Directory.GetFiles(Path)
                .Where(file => IsImage(file) && !System.IO.Path.GetFileName(file).StartsWith('.'))
                .Select(file => (Path: file, Number: LastNumber(System.IO.Path.GetFileNameWithoutExtension(file), out string stem), Stem: stem))
                .OrderBy(file => file.Stem, StringComparer.Ordinal)
                .ThenBy(file => file.Number)
                .ThenBy(file => file.Path, StringComparer.Ordinal)
                .ToList();
            for (int i = 0; i < files.Count; i++)
            {
                _entries.Add(new ImageFolderEntry(files[i].Path, files[i].Number, (long)Math.Round(i * 1e6 / framesPerSecond)));
                if (i == 0 || files[i - 1].Stem != files[i].Stem || files[i].Number is not long number || files[i - 1].Number is not long last)
                    continue;
                if (number > last + 1)
                    Report($"{(number == last + 2 ? $"number {last + 1} is" : $"numbers {last + 1} to {number - 1} are")} missing before {_entries[i].Name}", i);
                else if (number == last)
                    Report($"{_entries[i].Name} has the same number as {_entries[i - 1].Name}", i);
            }
        }

        /// <summary>The last number of a name, and the name without it. Names differ in nothing else within a sequence.</summary>
        public static long? LastNumber(string name, out string stem)
        {
            stem = name;
            int end = name.AsSpan().LastIndexOfAnyInRange('0', '9') + 1;
            if (end == 0)
                return null;
            int start = end;
            while (start > 0 && char.IsAsciiDigit(name[start - 1]) && end - start < 18)
                start--;
            stem = name[..start] + '\0' + name[end..];
            return long.Parse(name.AsSpan(start, end - start), NumberStyles.None, CultureInfo.InvariantCulture);
        }

        private void ReadFrameList(string list)
        {
            var byNumber = new Lazy<Dictionary<long, string>>(FilesByNumber);
            int lineNumber = 0;
            foreach (string line in File.ReadLines(list))
            {
                lineNumber++;
                if (line.Length == 0)
                    continue;
                if (!FrameListLine.TryParse(line, out FrameListLine parsed))
                {
                    Report($"line {lineNumber} of {FrameList} is damaged and left out");
                    continue;
                }

                if (!parsed.IsColor)
                    continue;
                string? path = parsed.File != null ? System.IO.Path.Combine(Path, System.IO.Path.GetFileName(parsed.File))
                    : parsed.Capture is long number && byNumber.Value.TryGetValue(number, out string? found) ? found : null;
                if (path == null || !(parsed.RawFormat != PixelFormat.None || IsImage(path)) || !File.Exists(path))
                    Report($"line {lineNumber} of {FrameList} names no picture that is there; it is left out");
                else
                    _entries.Add(new ImageFolderEntry(path, parsed.Capture, parsed.TimeUs, parsed.RawFormat, parsed.Width, parsed.Height));
            }

            // Files that have nothing to do with the list count as a plain folder.
            HasTimes = _entries.Count > 0;
            _entries.Sort((a, b) => a.TimeUs != b.TimeUs ? a.TimeUs.CompareTo(b.TimeUs) : string.CompareOrdinal(a.Path, b.Path));
        }

        private Dictionary<long, string> FilesByNumber()
        {
            var files = new Dictionary<long, string>();
            foreach (string file in Directory.GetFiles(Path).Where(IsImage).Order(StringComparer.Ordinal))
            {
                if (LastNumber(System.IO.Path.GetFileNameWithoutExtension(file), out _) is long number)
                    files.TryAdd(number, file);
            }

            return files;
        }

        private void Report(string what, int index = -1)
        {
            if (_problems.Count < 100)
                _problems.Add(new FrameProblem(-1, what, index));
        }
    }
}
