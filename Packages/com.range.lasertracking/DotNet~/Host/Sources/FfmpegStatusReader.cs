using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Text.RegularExpressions;
using System.Threading;

namespace LaserTracking.Host.Sources
{
    /// <summary>
    /// Reads what ffmpeg writes to its standard error on a thread of its own, so that ffmpeg never waits for us there: the presentation
    /// time of each frame ahead of its pixels, and the messages in between.
    /// </summary>
    internal sealed partial class FfmpegStatusReader
    {
        /// <summary>Stands for a frame without a time.</summary>
        public const long NoTime = long.MinValue;

        private const int MaxMessages = 20;

        private readonly Stream _stream;
        private readonly Queue<long> _times = new();
        private readonly List<string> _messages = new();
        private readonly byte[] _buffer = new byte[4096];
        private readonly byte[] _line = new byte[1024];
        private int _lineLength;
        private int _messageCount;
        private bool _ended;

        public FfmpegStatusReader(Stream standardError)
        {
            _stream = standardError;
            new Thread(ReadAll) { IsBackground = true, Name = "ffmpeg status" }.Start();
        }

        /// <summary>Messages so far, each one line without the decoder's name and address; the first few of many.</summary>
        public string[] Messages
        {
            get
            {
                lock (_times)
                    return _messages.ToArray();
            }
        }

        /// <summary>Number of messages so far, also of those that were not kept.</summary>
        public int MessageCount
        {
            get
            {
                lock (_times)
                    return _messageCount;
            }
        }

        /// <summary>Waits for the announcement of the next frame, in microseconds or <see cref="NoTime"/>. False: there is none.</summary>
        public bool TryPeek(out long timeUs)
        {
            lock (_times)
            {
                while (_times.Count == 0 && !_ended)
                    Monitor.Wait(_times);
                return _times.TryPeek(out timeUs);
            }
        }

        public void Take()
        {
            lock (_times)
                _times.Dequeue();
        }

        /// <summary>Waits until the program has closed its standard error.</summary>
        public void WaitForEnd()
        {
            lock (_times)
            {
                while (!_ended)
                    Monitor.Wait(_times);
            }
        }

        /// <summary>One line without the name and address of the part that speaks.</summary>
        public static string Condense(string message) =>
            Speaker().Replace(message, "").ReplaceLineEndings(" ").Trim().TrimEnd('.');

        [GeneratedRegex(@"\[[^\]]* @ (0x)?[0-9a-fA-F]+\] ?")]
        private static partial Regex Speaker();

        private void ReadAll()
        {
            try
            {
                int count;
                while ((count = _stream.Read(_buffer)) > 0)
                {
                    foreach (byte value in _buffer.AsSpan(0, count))
                    {
                        if (value is (byte)'\n' or (byte)'\r')
                            EndLine();
                        else if (_lineLength < _line.Length)
                            _line[_lineLength++] = value;
                    }
                }
            }
            catch (Exception exception) when (exception is IOException or ObjectDisposedException)
            {
                // The process was ended by us.
            }

            EndLine();
            lock (_times)
            {
                _ended = true;
                Monitor.PulseAll(_times);
            }
        }

        private void EndLine()
        {
            ReadOnlySpan<byte> line = _line.AsSpan(0, _lineLength);
            _lineLength = 0;

            // The filter that prints times also prints its own key. A message may have begun on the same line.
            if (line.IsEmpty || line.SequenceEqual("t=1"u8))
                return;
            if (TryReadTime(line, out long timeUs, out int start))
            {
                lock (_times)
                {
                    _times.Enqueue(timeUs);
                    Monitor.PulseAll(_times);
                }

                line = line[..start];
            }

            string message = Condense(Encoding.UTF8.GetString(line));
            if (message.Length == 0)
                return;
            lock (_times)
            {
                _messageCount++;
                if (_messages.Count < MaxMessages)
                    _messages.Add(message);
            }
        }

        /// <summary>"frame:12   pts:400000  pts_time:0.4".</summary>
        private static bool TryReadTime(ReadOnlySpan<byte> line, out long timeUs, out int start)
        {
            timeUs = NoTime;
            start = line.IndexOf("frame:"u8);
            int pts = line.IndexOf(" pts:"u8);
            if (start < 0 || pts < start || line.IndexOf(" pts_time:"u8) < pts)
                return false;
            ReadOnlySpan<byte> number = line[(pts + 5)..];
            if (System.Buffers.Text.Utf8Parser.TryParse(number, out long value, out _))
                timeUs = value;
            return true;
        }
    }
}
