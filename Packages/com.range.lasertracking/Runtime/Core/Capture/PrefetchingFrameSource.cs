using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace LaserTracking.Capture
{
    /// <summary>
    /// Reads another source a few frames ahead on a thread of its own, so that decoding and detection overlap. Same frames in the
    /// same order as the source itself; an exception of the source is thrown by <see cref="TryRead"/>. Owns the source.
    /// </summary>
    public sealed class PrefetchingFrameSource : IFrameSource
    {
        private readonly IFrameSource _source;
        private readonly Frame[] _ring;
        private readonly List<FrameProblem>[] _ringProblems;
        private readonly List<FrameProblem> _problems = new List<FrameProblem>();
        private readonly List<FrameProblem> _lastProblems = new List<FrameProblem>();
        private readonly object _lock = new object();
        private readonly Thread _reader;
        private int _first;
        private int _count;
        private bool _ended;
        private bool _disposed;
        private ExceptionDispatchInfo? _failure;

        /// <param name="source">Read only by this object's thread from now on.</param>
        /// <param name="depth">Frames read ahead, 1…64; bounds the memory.</param>
        public PrefetchingFrameSource(IFrameSource source, int depth = 3)
        {
            if (depth < 1 || depth > 64)
                throw new ArgumentOutOfRangeException(nameof(depth), depth, "1…64 frames");
            _source = source;
            _ring = new Frame[depth];
            _ringProblems = new List<FrameProblem>[depth];
            for (int i = 0; i < depth; i++)
            {
                _ring[i] = new Frame();
                _ringProblems[i] = new List<FrameProblem>();
            }

            _reader = new Thread(ReadAhead) { IsBackground = true, Name = "frames of " + source.Info.Name };
            _reader.Start();
        }

        public FrameSourceInfo Info => _source.Info;

        /// <summary>Grows with the frames handed out, not with those read ahead: two runs see the same.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems;

        public bool TryRead(Frame frame)
        {
            lock (_lock)
            {
                while (_count == 0 && !_ended)
                    Monitor.Wait(_lock);
                if (_count == 0)
                {
                    _problems.AddRange(_lastProblems);
                    _lastProblems.Clear();
                    _failure?.Throw();
                    return false;
                }

                _problems.AddRange(_ringProblems[_first]);

                frame.SwapWith(_ring[_first]);
                _first = (_first + 1) % _ring.Length;
                _count--;
                Monitor.PulseAll(_lock);
                return true;
            }
        }

        public void Dispose()
        {
            lock (_lock)
            {
                _disposed = true;
                Monitor.PulseAll(_lock);
            }

            _reader.Join();
            foreach (Frame frame in _ring)
                frame.Dispose();
            _source.Dispose();
        }

        private void ReadAhead()
        {
            int known = 0;
            try
            {
                while (true)
                {
                    Frame free;
                    List<FrameProblem> problems;
                    lock (_lock)
                    {
                        while (_count == _ring.Length && !_disposed)
                            Monitor.Wait(_lock);
                        if (_disposed)
                            return;
                        free = _ring[(_first + _count) % _ring.Length];
                        problems = _ringProblems[(_first + _count) % _ring.Length];
                    }

                    // Filled outside the lock: the consumer never touches slots beyond _count.
                    bool isRead = _source.TryRead(free);
                    if (!isRead)
                        problems = _lastProblems;
                    problems.Clear();
                    for (; known < _source.Problems.Count; known++)
                        problems.Add(_source.Problems[known]);
                    if (!isRead)
                        return;
                    lock (_lock)
                    {
                        _count++;
                        Monitor.PulseAll(_lock);
                    }
                }
            }
            catch (Exception problem)
            {
                _failure = ExceptionDispatchInfo.Capture(problem);
            }
            finally
            {
                lock (_lock)
                {
                    _ended = true;
                    Monitor.PulseAll(_lock);
                }
            }
        }
    }
}
