using System;
using System.IO;
using System.Threading;

namespace LaserTracking.Capture.Recording
{
    /// <summary>
    /// Takes lines and has a thread of its own write them, so that a slow disk holds nobody up. After the disk has refused, or so much
    /// waits that there is no room, nothing more is taken and <see cref="Problem"/> says why: what is in the file is whole up to there.
    /// Any thread writes; no allocation once warm.
    /// </summary>
    internal sealed class WriteBehindStream : Stream
    {
        /// <summary>Room for what waits, bytes.</summary>
        public const int DefaultCapacity = 8 << 20;

        private readonly FileStream? _file;
        private readonly Stream _inner;
        private readonly string _name;
        private readonly int _capacity;
        private readonly object _lock = new object();
        private readonly Thread _thread;
        private byte[] _filling = new byte[1 << 16];
        private byte[] _writing = new byte[1 << 16];
        private int _count;
        private bool _isBusy;
        private bool _isClosing;
        private string _problem = "";

        /// <param name="inner">Disposed with this.</param>
        /// <param name="name">For messages.</param>
        /// <param name="capacity">Room for what waits, bytes.</param>
        public WriteBehindStream(Stream inner, string name, int capacity = DefaultCapacity)
        {
            _inner = inner;
            _file = inner as FileStream;
            _name = name;
            _capacity = capacity;
            _thread = new Thread(WriteAll) { IsBackground = true, Name = "writer of " + Path.GetFileName(name) };
            _thread.Start();
        }

        /// <summary>Why the file ends early, one line with what to do; empty: it does not.</summary>
        public string Problem
        {
            get
            {
                lock (_lock)
                    return _problem;
            }
        }

        public override bool CanRead => false;

        public override bool CanSeek => false;

        public override bool CanWrite => true;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override void Write(byte[] buffer, int offset, int count) => Write(new ReadOnlySpan<byte>(buffer, offset, count));

        public override void Write(ReadOnlySpan<byte> bytes)
        {
            lock (_lock)
            {
                if (_isClosing || _problem.Length > 0)
                    return;
                if (_count + bytes.Length > _capacity)
                {
                    Fail("the disk does not keep up");
                    return;
                }

                if (_count + bytes.Length > _filling.Length)
                    Array.Resize(ref _filling, Math.Min(_capacity, Math.Max(2 * _filling.Length, _count + bytes.Length)));
                bytes.CopyTo(new Span<byte>(_filling, _count, bytes.Length));
                _count += bytes.Length;
                Monitor.PulseAll(_lock);
            }
        }

        /// <summary>Nothing: the thread writes as soon as it can.</summary>
        public override void Flush()
        {
        }

        /// <summary>Waits until the operating system has all that was written so far.</summary>
        public void Drain()
        {
            lock (_lock)
            {
                while ((_count > 0 || _isBusy) && _problem.Length == 0)
                    Monitor.Wait(_lock);
            }
        }

        public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        protected override void Dispose(bool disposing)
        {
            lock (_lock)
            {
                if (_isClosing)
                    return;
                _isClosing = true;
                Monitor.PulseAll(_lock);
            }

            _thread.Join();
            base.Dispose(disposing);
        }

        private void WriteAll()
        {
            try
            {
                while (TryTake(out byte[] bytes, out int count))
                    _inner.Write(bytes, 0, count);
                _inner.Flush();
                _file?.Flush(true);
                _inner.Dispose();
            }
            catch (Exception problem)
            {
                lock (_lock)
                    Fail(problem.Message);
            }
        }

        private bool TryTake(out byte[] bytes, out int count)
        {
            lock (_lock)
            {
                _isBusy = false;
                Monitor.PulseAll(_lock);
                while (_count == 0 && !_isClosing)
                    Monitor.Wait(_lock);
                (_filling, _writing) = (_writing, _filling);
                bytes = _writing;
                count = _count;
                _count = 0;
                _isBusy = count > 0;
                return count > 0;
            }
        }

        private void Fail(string why)
        {
            if (_problem.Length == 0)
                _problem = _name + ": the file ends early (" + why.Replace('\n', ' ').Replace("\r", "").TrimEnd('.') + "); make room or choose another place, and record again";
            Monitor.PulseAll(_lock);
        }
    }
}
