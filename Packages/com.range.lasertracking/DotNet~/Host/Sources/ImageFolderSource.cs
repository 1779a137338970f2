using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>
    /// A folder of numbered pictures in the order of their numbers. Baseline JPEG is decoded as a camera's (see <see cref="JpegDecoder"/>),
    /// everything else through ffmpeg to Bgra32. All pictures have the size of the first one that can be read; others, and damaged
    /// ones, are absent from their frame and reported. Times: see <see cref="ImageFolder"/>.
    /// </summary>
    public sealed class ImageFolderSource : IFrameSource
    {
        private const int MaxProblems = 200;

        private readonly ImageFolder _folder;
        private readonly JpegDecoder _jpeg = new();
        private readonly List<FrameProblem> _problems;
        private byte[] _file = new byte[256 * 1024];
        private FfmpegFrameStream? _stream;
        private int _streamStart;
        private int _streamEnd;
        private int _next;

        /// <param name="path">The folder.</param>
        /// <param name="framesPerSecond">Spacing of the pictures where no frames.jsonl tells their times.</param>
        /// <exception cref="InputException">No picture in it can be read.</exception>
        public ImageFolderSource(string path, double framesPerSecond = 30)
        {
            _folder = ImageFolder.Open(path, framesPerSecond);
            _problems = new List<FrameProblem>(_folder.Problems);
            (int width, int height) = FirstSize();
            long lastUs = _folder.Entries[^1].TimeUs;
            Info = new FrameSourceInfo(Path.GetFileName(Path.TrimEndingDirectorySeparator(Path.GetFullPath(path))), width, height,
                _folder.HasTimes ? 0 : framesPerSecond, lastUs - _folder.Entries[0].TimeUs);
        }

        public FrameSourceInfo Info { get; }

        /// <summary>At most 200 entries.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems;

        /// <summary>Number of pictures in the folder.</summary>
        public int Count => _folder.Entries.Count;

        /// <summary>The first picture's format as its file name has it, in upper case: "PNG".</summary>
        public string Format => _folder.Entries[0].IsJpeg ? "JPEG" : _folder.Entries[0].Extension[1..].ToUpperInvariant();

        /// <summary>Time of the first picture in microseconds.</summary>
        public long StartUs => _folder.Entries[0].TimeUs;

        public bool TryRead(Frame frame)
        {
            if (_next >= _folder.Entries.Count)
                return false;
            int index = _next++;
            ImageFolderEntry entry = _folder.Entries[index];
            frame.Begin(index, entry.TimeUs);
            if (entry.IsRaw)
                ReadRaw(entry, index, frame.Color);
            else if (entry.IsJpeg)
                ReadJpeg(entry, index, frame.Color);
            else
                ReadByFfmpeg(index, frame.Color);
            return true;
        }

        public void Dispose()
        {
            _next = int.MaxValue;
            _stream?.Dispose();
            _stream = null;
        }

        private void ReadRaw(ImageFolderEntry entry, int index, Image image)
        {
            if ((entry.RawWidth, entry.RawHeight) != (Info.Width, Info.Height))
            {
                Report(SizeProblem(entry, entry.RawWidth, entry.RawHeight), index);
                return;
            }

            string problem;
            try
            {
                ReadOnlySpan<byte> bytes = ReadFile(entry.Path);
                if (bytes.Length == Image.TightSize(entry.RawFormat, entry.RawWidth, entry.RawHeight))
                {
                    image.Reset(entry.RawFormat, entry.RawWidth, entry.RawHeight, entry.TimeUs);
                    bytes.CopyTo(image.Bytes);
                    return;
                }

                problem = $"has {bytes.Length} bytes, which is not {entry.RawWidth}×{entry.RawHeight} of {entry.RawFormat}";
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                problem = exception.Message.ReplaceLineEndings(" ");
            }

            Report(entry.Name + ": " + problem + "; the picture is left out", index);
        }

        private void ReadJpeg(ImageFolderEntry entry, int index, Image image)
        {
            string problem;
            try
            {
                if (_jpeg.TryDecode(ReadFile(entry.Path), image, entry.TimeUs, out problem))
                {
                    if (image.Width == Info.Width && image.Height == Info.Height)
                        return;
                    Report(SizeProblem(entry, image.Width, image.Height), index);
                    image.Clear();
                    return;
                }
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                problem = exception.Message.ReplaceLineEndings(" ");
            }

            if (problem.Contains("not supported", StringComparison.Ordinal))
                ReadByFfmpeg(index, image);
            else
                Report(entry.Name + ": " + problem + "; the picture is left out", index);
        }

        private ReadOnlySpan<byte> ReadFile(string path)
        {
            using FileStream file = File.OpenRead(path);
            int length = (int)Math.Min(file.Length, 1 << 30);
            if (_file.Length < length)
                _file = new byte[length];
            return _file.AsSpan(0, file.ReadAtLeast(_file.AsSpan(0, length), length, throwOnEndOfStream: false));
        }

        private void ReadByFfmpeg(int index, Image image)
        {
            ImageFolderEntry entry = _folder.Entries[index];
            if (!entry.IsJpeg && ImageFileHeader.TryReadSize(entry.Path, out int width, out int height) && (width, height) != (Info.Width, Info.Height))
            {
                Report(SizeProblem(entry, width, height), index);
                return;
            }

            if (_stream == null || index >= _streamEnd)
                StartStream(index, isAlone: entry.IsJpeg);
            if (TryReadStream(index, image))
                return;

            // A file that is not of the same kind as the first of its list still has a chance by itself.
            if (_streamEnd - _streamStart > 1)
            {
                StartStream(index, isAlone: true);
                if (TryReadStream(index, image))
                    return;
            }

            image.Clear();
            Report(entry.Name + ": cannot be decoded; the picture is left out", index);
        }

        /// <summary>Each file lasts one second in the list, so the time tells which file a frame is from.</summary>
        private bool TryReadStream(int index, Image image)
        {
            while (_stream!.TryPeekTime(out long timeUs))
            {
                int file = _streamStart + (int)((timeUs + 500_000) / 1_000_000);
                if (file > index)
                    return false;
                image.Reset(PixelFormat.Bgra32, Info.Width, Info.Height, _folder.Entries[index].TimeUs);
                if (!_stream.TryReadPixels(image.Bytes))
                    return false;
                if (file == index)
                    return true;
            }

            return false;
        }

        /// <summary>Starts one process for this picture, and for those of the same kind that follow it.</summary>
        private void StartStream(int index, bool isAlone)
        {
            _stream?.Dispose();
            string extension = _folder.Entries[index].Extension;
            var list = new StringBuilder("ffconcat version 1.0\n");
            int end = index;
            do
            {
                string quoted = VideoProbe.InputOf(_folder.Entries[end].Path).Replace("'", @"'\''", StringComparison.Ordinal);
                list.Append(CultureInfo.InvariantCulture, $"file '{quoted}'\nduration 1\n");
                end++;
            }
            while (!isAlone && end < Count && _folder.Entries[end].Extension == extension && !_folder.Entries[end].IsRaw);

            _streamStart = index;
            _streamEnd = end;
            _stream = new FfmpegFrameStream(FfmpegProgram.Require("ffmpeg", _folder.Path), ["-f", "concat", "-safe", "0", "-i", "pipe:0"],
                Info.Width, Info.Height, list.ToString());
        }

        private string SizeProblem(ImageFolderEntry entry, int width, int height) =>
            $"{entry.Name}: is {width}×{height}, the others are {Info.Width}×{Info.Height}; the picture is left out";

        private (int Width, int Height) FirstSize()
        {
            using var image = new Image();
            foreach (ImageFolderEntry entry in _folder.Entries.Take(20))
            {
                if (entry.IsRaw)
                    return (entry.RawWidth, entry.RawHeight);
                if (ImageFileHeader.TryReadSize(entry.Path, out int width, out int height))
                    return (width, height);
                if (!entry.IsJpeg)
                    continue;
                string problem;
                try
                {
                    if (_jpeg.TryDecode(ReadFile(entry.Path), image, 0, out problem))
                        return (image.Width, image.Height);
                }
                catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
                {
                    continue;
                }

                if (problem.Contains("not supported", StringComparison.Ordinal))
                {
                    VideoProbe probe = VideoProbe.Open(entry.Path);
                    return (probe.Width, probe.Height);
                }
            }

            throw new InputException(_folder.Path, "none of the first pictures can be read", "check the files");
        }

        private void Report(string what, int index)
        {
            if (_problems.Count < MaxProblems)
                _problems.Add(new FrameProblem(-1, what, index));
        }
    }
}
