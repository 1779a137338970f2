using System;
using System.Collections.Generic;
using System.IO;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>
    /// Any video that ffmpeg reads, frame by frame in the order of display, as Bgra32 with the file's own, possibly uneven, times. Frames that
    /// the file's edit list leaves out are left out; the first frame's time may be above 0. Frames stand upright where the file says
    /// how. A file that breaks off gives its frames up to there, then a problem.
    /// </summary>
    public sealed class VideoSource : IFrameSource
    {
        private readonly VideoProbe _probe;
        private readonly FfmpegFrameStream _stream;
        private readonly int _width;
        private readonly int _height;
        private readonly List<FrameProblem> _problems = new();
        private int _nextIndex;
        private bool _ended;

        /// <param name="path">The file.</param>
        /// <param name="maxWidth">Wider pictures are scaled down to this width, px.</param>
        /// <exception cref="InputException">ffmpeg is missing, or the file is no video or holds no frame.</exception>
        public VideoSource(string path, int maxWidth = int.MaxValue)
        {
            _probe = VideoProbe.Open(path);
            _width = Math.Min(maxWidth, _probe.Width);
            _height = _width == _probe.Width ? _probe.Height : Math.Max(1, (int)Math.Round((double)_probe.Height * _width / _probe.Width));
            Info = new FrameSourceInfo(Path.GetFileName(path), _width, _height, _probe.FramesPerSecond, _probe.DurationUs);
            _stream = new FfmpegFrameStream(FfmpegProgram.Require("ffmpeg", path), ["-i", VideoProbe.InputOf(path)], _width, _height);
            if (_stream.TryPeekTime(out _))
                return;
            _stream.WaitForExit();
            string[] messages = _stream.Messages;
            _stream.Dispose();
            string reason = messages.Length > 0 ? " (" + messages[^1].Replace(VideoProbe.InputOf(path) + ": ", "", StringComparison.Ordinal) + ")" : "";
            throw new InputException(path, "has no frame that can be decoded" + reason, "record or copy it again");
        }

        public FrameSourceInfo Info { get; }

        /// <summary>At most two: what the decoder complained of, and where the file breaks off. Complete once the stream has ended.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems;

        /// <summary>The decoder's process, for tests.</summary>
        internal int ProcessId => _stream.ProcessId;

        public bool TryRead(Frame frame)
        {
            if (_ended)
                return false;
            if (!_stream.TryPeekTime(out long timeUs))
            {
                End(isCut: false);
                return false;
            }

            // Raw streams carry no times; their nominal rate is all there is.
            if (timeUs == FfmpegStatusReader.NoTime)
                timeUs = (long)Math.Round(_nextIndex * 1e6 / (_probe.FramesPerSecond > 0 ? _probe.FramesPerSecond : 25));
            frame.Begin(_nextIndex, timeUs);
            frame.Color.Reset(PixelFormat.Bgra32, _width, _height, timeUs);
            if (_stream.TryReadPixels(frame.Color.Bytes))
            {
                _nextIndex++;
                return true;
            }

            frame.Color.Clear();
            End(isCut: true);
            return false;
        }

        public void Dispose()
        {
            _ended = true;
            _stream.Dispose();
        }

        private void End(bool isCut)
        {
            _ended = true;
            isCut |= _stream.WaitForExit() != 0;
            string[] messages = _stream.Messages;
            if (messages.Length > 0)
            {
                string more = _stream.MessageCount > 1 ? $" (and {_stream.MessageCount - 1} more)" : "";
                _problems.Add(new FrameProblem(-1, "the decoder found damage: " + messages[0] + more));
                isCut |= Array.Exists(messages, VideoProbe.MeansCut);
            }

            // Of containers that say how many frames they hold, AVI is the one that ffmpeg lets end early without a word.
            bool isShort = _probe.ContainerFormat == "avi" && _probe.DeclaredFrames > _nextIndex;
            if (isCut || isShort)
            {
                string declared = isShort ? $" of {_probe.DeclaredFrames}" : "";
                _problems.Add(new FrameProblem(-1, $"the video breaks off after {_nextIndex}{declared} frames", _nextIndex));
            }
        }
    }
}
