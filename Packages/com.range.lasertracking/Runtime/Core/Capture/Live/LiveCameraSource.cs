using System;
using System.Collections.Generic;
using System.Threading;

namespace LaserTracking.Capture.Live
{
    /// <summary>
    /// Frames of a live camera, for a thread of its own. Never ends: while the camera is away, <see cref="TryRead"/> gives frames without
    /// a picture, about ten a second, and <see cref="Problems"/> says why. All times are on the host's clock (<see cref="DeviceClock"/>).
    /// Allocates nothing while pictures come.
    /// </summary>
    public sealed class LiveCameraSource : IFrameSource
    {
        private readonly LiveCameraLoop _loop;
        private readonly LiveCameraSettings _settings;
        private readonly Func<long> _nowUs;
        private readonly ProblemLog _problems = new ProblemLog();
        private int _nextIndex;
        private long _lastTimeUs = long.MinValue;
        private bool _isDisposed;

        /// <param name="camera">Opened with the first read; used by the reading thread only.</param>
        /// <param name="nowUs">Host's clock, microseconds, never back; the same for all sources of a session.</param>
        /// <param name="settings">Defaults when null.</param>
        public LiveCameraSource(ILiveCamera camera, Func<long> nowUs, LiveCameraSettings? settings = null)
        {
            _settings = settings ?? new LiveCameraSettings();
            _nowUs = nowUs;
            _loop = new LiveCameraLoop(camera, _settings, nowUs, text => _problems.Add(-1, text, _nextIndex));
            Info = camera.Info;
        }

        public FrameSourceInfo Info { get; }

        /// <summary>What happened to the camera: missing, lost, back, settings refused.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems.Problems;

        /// <summary>
        /// The next picture, or after a tenth of a second a frame without one; as long as the vendor's library needs where that opens a
        /// camera. False only after <see cref="Dispose"/>.
        /// </summary>
        public bool TryRead(Frame frame)
        {
            if (_isDisposed)
                return false;
            // A step that opens the camera takes no picture yet.
            bool isPicture = false;
            for (int step = 0; step < 2 && !isPicture; step++)
            {
                isPicture = _loop.TryStep(frame, out int waitMs);
                if (waitMs == 0)
                    continue;
                Thread.Sleep(waitMs);
                break;
            }

            if (isPicture)
                frame.Index = _nextIndex;
            else
                frame.Begin(_nextIndex, TimeWithoutPicture());
            _nextIndex++;
            _lastTimeUs = frame.TimeUs;
            return true;
        }

        /// <summary>Gives the camera back; by the thread that read it, or after it.</summary>
        public void Dispose()
        {
            if (!_isDisposed)
                _loop.Close();
            _isDisposed = true;
        }

        /// <summary>A picture may still arrive late from a camera that is open, so time hardly passes; without a camera it goes on.</summary>
        private long TimeWithoutPicture()
        {
            long now = _nowUs() - (long)(_settings.LatencyMs * 1000);
            if (_lastTimeUs == long.MinValue)
                return now;
            return _loop.IsOpen ? _lastTimeUs + 1 : Math.Max(_lastTimeUs + 1, now);
        }
    }
}
