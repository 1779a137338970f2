using System;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace LaserTracking.Capture
{
    /// <summary>
    /// Hands frames from a thread that cannot wait to one that may be late: when it is full the oldest frame is left out and counted.
    /// One thread puts, one takes; pixels are exchanged, never copied; no allocation once warm.
    /// </summary>
    public sealed class FrameMailbox : IDisposable
    {
        private readonly object _lock = new object();
        private readonly Frame[] _ring;
        private int _first;
        private int _count;
        private long _dropped;
        private bool _isClosed;
        private ExceptionDispatchInfo? _failure;

        /// <param name="depth">Frames that may wait, 1…64: what a short stall of the reader costs nothing.</param>
        public FrameMailbox(int depth = 4)
        {
            if (depth < 1 || depth > 64)
                throw new ArgumentOutOfRangeException(nameof(depth), depth, "1…64 frames");
            _ring = new Frame[depth];
            for (int i = 0; i < depth; i++)
                _ring[i] = new Frame();
        }

        /// <summary>Frames left out so far because the reader was late.</summary>
        public long Dropped
        {
            get
            {
                lock (_lock)
                    return _dropped;
            }
        }

        /// <summary>The next frame put will cost none that waits.</summary>
        public bool HasRoom
        {
            get
            {
                lock (_lock)
                    return _count < _ring.Length;
            }
        }

        /// <summary>No frame will be put any more; some may still wait.</summary>
        public bool IsClosed
        {
            get
            {
                lock (_lock)
                    return _isClosed;
            }
        }

        /// <summary>Takes the frame's content and gives back an older one to fill next. Ignored once closed.</summary>
        public void Put(Frame filled)
        {
            lock (_lock)
            {
                if (_isClosed)
                    return;
                if (_count == _ring.Length)
                {
                    _first = (_first + 1) % _ring.Length;
                    _count--;
                    _dropped++;
                }

                _ring[(_first + _count) % _ring.Length].SwapWith(filled);
                _count++;
                Monitor.PulseAll(_lock);
            }
        }

        /// <summary>Takes the oldest frame, waiting for one; false when it is closed and empty. Throws what it was closed with.</summary>
        public bool TryTake(Frame frame)
        {
            lock (_lock)
            {
                while (_count == 0 && !_isClosed)
                    Monitor.Wait(_lock);
                if (_count == 0)
                    _failure?.Throw();
                return TryTakeWaiting(frame);
            }
        }

        /// <summary>Takes the oldest frame if one is there; never waits.</summary>
        public bool TryTakeNow(Frame frame)
        {
            lock (_lock)
                return TryTakeWaiting(frame);
        }

        /// <summary>Lets a waiting reader go; what waits can still be taken. The first call counts.</summary>
        /// <param name="failure">Why there is no more, for the reader; null: a usual end.</param>
        public void Close(Exception? failure = null)
        {
            lock (_lock)
            {
                if (!_isClosed && failure != null)
                    _failure = ExceptionDispatchInfo.Capture(failure);
                _isClosed = true;
                Monitor.PulseAll(_lock);
            }
        }

        /// <summary>After both threads are done with it.</summary>
        public void Dispose()
        {
            Close();
            foreach (Frame frame in _ring)
                frame.Dispose();
        }

        private bool TryTakeWaiting(Frame frame)
        {
            if (_count == 0)
                return false;
            frame.SwapWith(_ring[_first]);
            _first = (_first + 1) % _ring.Length;
            _count--;
            return true;
        }
    }
}
