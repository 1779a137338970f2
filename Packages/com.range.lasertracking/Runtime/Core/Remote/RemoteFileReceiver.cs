using System;
using System.IO;
using System.Threading;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Watches a file that a detector in another process of this machine replaces again and again, on a thread of its own. Its
    /// lines are messages; they count together or, when one of them is wrong, not at all. Files are not signed: whoever may
    /// write into the folder is believed. Looks every 5 ms, because notices of changes are late or missing on some systems.
    /// </summary>
    public sealed class RemoteFileReceiver : IDisposable
    {
        private const int MostBytes = 65536;
        private const int PollMs = 5;
        private const long PatienceUs = 100_000;

        private readonly string _path;
        private readonly RemoteGate _gate;
        private readonly IClock _clock;
        private readonly long _maximumAgeUs;
        private readonly Thread _thread;
        private readonly ManualResetEvent _stop = new ManualResetEvent(false);
        private byte[] _buffer = new byte[MostBytes];
        private byte[] _last = new byte[MostBytes];
        private int _lastLength = -1;
        private DateTime _stamp;
        private long _size;
        private long _changedUs;
        private bool _isDone;

        /// <param name="path">May appear later.</param>
        /// <param name="settings">Age, rate and capacity count; address, port and key do not.</param>
        /// <param name="clock">The wall clock.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        /// <exception cref="InputException">The path is no name for a file.</exception>
        public RemoteFileReceiver(string path, RemoteSettings settings, IClock clock)
        {
            settings.Validate();
            RemoteFile.CheckName(path);
            _path = path;
            _clock = clock;
            _maximumAgeUs = (long)(settings.MaximumAgeMs * 1000);
            Inbox = new RemoteInbox(settings.ShotCapacity);
            _gate = new RemoteGate(settings, Inbox);
            _thread = new Thread(Watch) { IsBackground = true, Name = "remote file" };
            _thread.Start();
        }

        public RemoteInbox Inbox { get; }

        /// <summary>Stops watching and waits for the thread.</summary>
        public void Dispose()
        {
            _stop.Set();
            _thread.Join();
            _stop.Dispose();
            _gate.Dispose();
        }

        private void Watch()
        {
            do
                Look(_clock.NowUs);
            while (!_stop.WaitOne(PollMs));
        }

        /// <summary>
        /// Takes what changed. A file that is wrong may still be on its way, from a writer that does not replace it at once: it gets
        /// a little time before it counts as wrong, once.
        /// </summary>
        private void Look(long nowUs)
        {
            var file = new FileInfo(_path);
            if (!file.Exists)
                return;
            DateTime stamp;
            long size;
            try
            {
                stamp = file.LastWriteTimeUtc;
                size = file.Length;
            }
            catch (IOException)
            {
                return;
            }

            if (stamp != _stamp || size != _size)
            {
                _stamp = stamp;
                _size = size;
                _changedUs = nowUs;
                _isDone = false;
            }
            else if (_isDone)
            {
                return;
            }

            RemoteDrop drop = RemoteFile.TryRead(_path, _buffer, out int length) ? CheckAll(length) : size >= MostBytes ? RemoteDrop.Oversized : RemoteDrop.Failed;
            if (drop == RemoteDrop.None)
            {
                _isDone = true;
                if (!new ReadOnlySpan<byte>(_buffer, 0, length).SequenceEqual(new ReadOnlySpan<byte>(_last, 0, Math.Max(0, _lastLength))))
                    TakeAll(length, nowUs);
            }
            else if (nowUs - _changedUs > PatienceUs || nowUs < _changedUs)
            {
                _isDone = true;
                Inbox.Count(drop, nowUs);
            }
        }

        private RemoteDrop CheckAll(int length)
        {
            int messages = 0;
            for (int at = 0; TryLine(length, ref at, out ReadOnlySpan<byte> line);)
            {
                RemoteDrop drop = RemoteMessageReader.Read(line, out _);
                if (drop != RemoteDrop.None)
                    return drop;
                messages++;
            }

            return messages > 0 || length == 0 ? RemoteDrop.None : RemoteDrop.NotJson;
        }

        private void TakeAll(int length, long nowUs)
        {
            long writtenUs = (_stamp - DateTime.UnixEpoch).Ticks / 10;
            for (int at = 0; TryLine(length, ref at, out ReadOnlySpan<byte> line);)
            {
                RemoteMessageReader.Read(line, out RemoteMessage message);
                // A message that does not say when it was sent is as old as the file: what lay there yesterday is not now.
                if (!message.HasHead && Math.Abs(nowUs - writtenUs) > _maximumAgeUs)
                    Inbox.Count(RemoteDrop.Stale, nowUs);
                else
                    _gate.AcceptFromFile(message, nowUs);
            }

            (_buffer, _last) = (_last, _buffer);
            _lastLength = length;
        }

        /// <summary>The next message, whether it stands on one line or, as indenting writers make it, on many.</summary>
        private bool TryLine(int length, ref int at, out ReadOnlySpan<byte> line)
        {
            var text = new ReadOnlySpan<byte>(_buffer, 0, length);
            at = Utf8JsonText.SkipSpace(text, at);
            line = text.Slice(at);
            if (at == length)
                return false;
            int end = Utf8JsonText.Value(text, at, 64);
            if (end < 0)
                end = length;
            line = text.Slice(at, end - at);
            at = end;
            return true;
        }
    }
}
