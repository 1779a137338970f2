using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Threading.Tasks;
using LaserTracking.Imaging;

namespace LaserTracking.Host.Sources
{
    /// <summary>
    /// One ffmpeg process that decodes its input to raw BGRA frames of one size on its standard output and announces each frame's time
    /// on its standard error. ffmpeg is never ahead by more than the pipe and its own queues hold. Disposing ends the process.
    /// </summary>
    internal sealed class FfmpegFrameStream : IDisposable
    {
        private readonly Process _process;
        private readonly Stream _pixels;
        private readonly FfmpegStatusReader _status;
        private bool _ended;

        /// <param name="program">Path of ffmpeg.</param>
        /// <param name="input">Arguments up to and including the input.</param>
        /// <param name="width">Frames of another size are scaled to this one.</param>
        /// <param name="height">See <paramref name="width"/>.</param>
        /// <param name="standardInput">What ffmpeg reads from its standard input, or null.</param>
        public FfmpegFrameStream(string program, IEnumerable<string> input, int width, int height, string? standardInput = null)
        {
            var start = new ProcessStartInfo(program)
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                RedirectStandardInput = standardInput != null,
                UseShellExecute = false,
                CreateNoWindow = true,
            };
            string size = string.Create(CultureInfo.InvariantCulture, $"{width}:{height}");

            // The scaler's exact mode gives the same pixels on every processor.
            string filters = "settb=1/1000000,scale=" + size + ":flags=bicubic+accurate_rnd+bitexact,format=bgra,"
                + @"metadata=mode=add:key=t:value=1,metadata=mode=print:file=pipe\\:2:direct=1";
            Append(start, "-hide_banner", "-nostdin", "-nostats", "-v", "error");

            // Times as they stand in the file, not counted from its beginning.
            Append(start, "-copyts", "-protocol_whitelist", "file,pipe");
            foreach (string argument in input)
                start.ArgumentList.Add(argument);
            Append(start, "-map", "0:V:0", FfmpegProgram.PassthroughOption(program), "passthrough", "-enc_time_base", "1:1000000", "-vf", filters);
            Append(start, "-f", "rawvideo", "-pix_fmt", "bgra", "pipe:1");

            _process = Process.Start(start) ?? throw new InvalidOperationException("ffmpeg did not start");
            _pixels = _process.StandardOutput.BaseStream;
            _status = new FfmpegStatusReader(_process.StandardError.BaseStream);
            if (standardInput != null)
                Task.Run(() => Feed(standardInput));
        }

        public int ProcessId => _process.Id;

        /// <summary>What ffmpeg complained of so far, one line each.</summary>
        public string[] Messages => _status.Messages;

        public int MessageCount => _status.MessageCount;

        /// <summary>Waits until the next frame is announced and tells its time, or <see cref="FfmpegStatusReader.NoTime"/>. False at the end.</summary>
        public bool TryPeekTime(out long timeUs)
        {
            timeUs = 0;
            return !_ended && _status.TryPeek(out timeUs);
        }

        /// <summary>Reads the announced frame. False when the stream broke off inside it.</summary>
        public bool TryReadPixels(Span<byte> bgra)
        {
            _status.Take();
            if (_pixels.ReadAtLeast(bgra, bgra.Length, throwOnEndOfStream: false) == bgra.Length)
                return true;
            _ended = true;
            return false;
        }

        /// <summary>Waits for ffmpeg to end and returns its exit code. To be called when no frame is left.</summary>
        public int WaitForExit()
        {
            _status.WaitForEnd();
            _process.WaitForExit();
            return _process.ExitCode;
        }

        public void Dispose()
        {
            try
            {
                if (!_process.HasExited)
                    _process.Kill();
            }
            catch (InvalidOperationException)
            {
                // It ended by itself in between.
            }

            _process.WaitForExit();
            _process.Dispose();
        }

        private static void Append(ProcessStartInfo start, params ReadOnlySpan<string> arguments)
        {
            foreach (string argument in arguments)
                start.ArgumentList.Add(argument);
        }

        private void Feed(string text)
        {
            try
            {
                using StreamWriter writer = _process.StandardInput;
                writer.Write(text);
            }
            catch (IOException)
            {
                // ffmpeg gave up; its messages say why.
            }
        }
    }
}
