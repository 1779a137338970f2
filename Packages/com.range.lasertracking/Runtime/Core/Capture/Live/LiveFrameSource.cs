using System;
using System.Collections.Generic;
using System.Threading;

namespace LaserTracking.Capture.Live
{
    /// <summary>
    /// Frames of a live camera, read by a thread of its own so that neither a slow vendor's library nor a missing camera holds anybody
    /// up. Never ends: while the camera is away, <see cref="TryRead"/> gives frames without a picture, about ten a second, and
    /// <see cref="Problems"/> says why. All times are on the host's clock (<see cref="DeviceClock"/>). Pictures wait in a short queue; when
    /// the reader is late the oldest go and are counted. Allocates nothing while pictures come.
    /// </summary>
    public sealed class LiveFrameSource : IFrameSource
    {
        private readonly LiveCameraLoop _loop;
        private readonly LiveCameraSettings _settings;
        private readonly Func<long> _nowUs;
        private readonly Frame[] _queue;
        private readonly Queue<string> _reports = new Queue<string>();
        private readonly ProblemLog _problems = new ProblemLog();
        private readonly object _lock = new object();
        private readonly Thread _thread;
        private int _first;
        private int _count;
        private int _nextIndex;
        private long _lastTimeUs = long.MinValue;
        private long _dropped;
        private long _droppedReported;
        private bool _isOpen;
        private bool _isStopped;

        /// <param name="camera">Used by this object's thread only, from now on.</param>
        /// <param name="nowUs">Host's clock, microseconds, never back; the same for all sources of a session. Called from any thread.</param>
        /// <param name="settings">Defaults when null.</param>
        public LiveFrameSource(ILiveCamera camera, Func<long> nowUs, LiveCameraSettings? settings = null)
        {
            _settings = settings ?? new LiveCameraSettings();
            _nowUs = nowUs;
            _loop = new LiveCameraLoop(camera, _settings, nowUs, Report);
            Info = camera.Info;
            _queue = new Frame[_settings.QueueFrames];
            for (int i = 0; i < _queue.Length; i++)
                _queue[i] = new Frame();
            _thread = new Thread(Capture) { IsBackground = true, Name = "camera " + camera.Info.Name };
            _thread.Start();
        }

        public FrameSourceInfo Info { get; }

        /// <summary>What happened to the camera, as far as the frames read: lost, back, settings refused, pictures dropped.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems.Problems;

        /// <summary>Pictures that the reader was too late for.</summary>
        public long DroppedCount
        {
            get
            {
                lock (_lock)
                    return _dropped;
            }
        }

        /// <summary>The next picture, or after a tenth of a second a frame without one. False only after <see cref="Dispose"/>.</summary>
        public bool TryRead(Frame frame)
        {
            lock (_lock)
            {
                if (_count == 0 && !_isStopped)
                    Monitor.Wait(_lock, _settings.ReadTimeoutMs);
                if (_isStopped)
                    return false;
                if (_count > 0)
                {
                    frame.SwapWith(_queue[_first]);
                    _first = (_first + 1) % _queue.Length;
                    _count--;
                    frame.Index = _nextIndex++;
                }
                else
                {
                    frame.Begin(_nextIndex++, TimeWithoutPicture());
                }

                _lastTimeUs = frame.TimeUs;
                TakeReports(frame.Index);
                return true;
            }
        }

        /// <summary>Ends the camera's thread; returns within <see cref="LiveCameraSettings.StopMs"/> even when the vendor's library hangs.</summary>
        public void Dispose()
        {
            lock (_lock)
            {
                _isStopped = true;
                Monitor.PulseAll(_lock);
            }

            _thread.Join(_settings.StopMs);
        }

        /// <summary>A picture may still arrive late from a camera that is open, so time hardly passes; without a camera it goes on.</summary>
        private long TimeWithoutPicture()
        {
            long now = _nowUs() - (long)(_settings.LatencyMs * 1000);
            if (_lastTimeUs == long.MinValue)
                return now;
            return _isOpen ? _lastTimeUs + 1 : Math.Max(_lastTimeUs + 1, now);
        }

        private void TakeReports(int frameIndex)
        {
            while (_reports.Count > 0)
                _problems.Add(-1, _reports.Dequeue(), frameIndex);
            // At 1, 2, 4, 8 …: an overload that goes on must not fill the log.
            if (_dropped < 2 * _droppedReported || _dropped == _droppedReported)
                return;
            _droppedReported = _dropped;
            _problems.Add(-1, Info.Name + ": pictures come faster than they are processed, " + _dropped + " dropped so far; a shot in them is lost", frameIndex);
        }

        private void Report(string text)
        {
            lock (_lock)
            {
                if (_reports.Count < ProblemLog.Capacity)
                    _reports.Enqueue(text);
            }
        }

        private void Capture()
        {
            var frame = new Frame();
            while (true)
            {
                bool isPicture = _loop.TryStep(frame, out int waitMs);
                lock (_lock)
                {
                    _isOpen = _loop.IsOpen;
                    if (isPicture)
                        Enqueue(frame);
                    if (waitMs > 0 && !_isStopped)
                        Monitor.Wait(_lock, waitMs);
                    if (_isStopped)
                        break;
                }
            }

            // By this thread: the vendor's device belongs to it, and nobody else waits for it if it hangs.
            _loop.Close();
            frame.Dispose();
            foreach (Frame queued in _queue)
                queued.Dispose();
        }

        private void Enqueue(Frame frame)
        {
            if (_count == _queue.Length)
            {
                _first = (_first + 1) % _queue.Length;
                _count--;
                _dropped++;
            }

            frame.SwapWith(_queue[(_first + _count) % _queue.Length]);
            _count++;
            Monitor.PulseAll(_lock);
        }
    }
}
