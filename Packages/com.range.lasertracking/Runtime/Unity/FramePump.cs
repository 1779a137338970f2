using System;
using LaserTracking.Capture;
using LaserTracking.Pipeline;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Feeds a pipeline from Unity's clock: a frame is due when as much time has passed in Unity as in the source. The scene's clock
    /// is camera 0's.
    /// </summary>
    internal sealed class FramePump : IDisposable
    {
        // A machine that falls behind shall still draw: it catches up over several updates.
        private const int MaxFramesPerUpdate = 8;

        private readonly RangePipeline _pipeline;
        private readonly IFrameSource _screenCamera;
        private readonly IFrameSource? _handCamera;
        private readonly SessionRunner _runner;
        private readonly long? _sceneTimeZeroUs;
        private readonly double _latencyS;
        private bool _hasBegun;
        private bool _hasFrame;
        private long _firstTimeUs;
        private double _beganAtS;
        private double _lastUpdateS;

        /// <param name="pipeline">Already begun.</param>
        /// <param name="screenCamera">Camera 0; owned from now on.</param>
        /// <param name="handCamera">Camera 1 or null; owned from now on.</param>
        /// <param name="handClockOffsetUs">Brings camera 1's times on camera 0's clock.</param>
        /// <param name="sceneTimeZeroUs">As the pipeline's: camera 0's time at scene time zero; null: its first frame's.</param>
        /// <param name="latencyS">From the light to the frame of camera 0, seconds.</param>
        public FramePump(RangePipeline pipeline, IFrameSource screenCamera, IFrameSource? handCamera, long handClockOffsetUs, long? sceneTimeZeroUs,
            double latencyS)
        {
            _pipeline = pipeline;
            _screenCamera = screenCamera;
            _handCamera = handCamera;
            _runner = new SessionRunner(pipeline, screenCamera, handCamera, handClockOffsetUs);
            _sceneTimeZeroUs = sceneTimeZeroUs;
            _latencyS = latencyS;
        }

        /// <summary>The source has no more frames and the session is closed.</summary>
        public bool IsAtEnd { get; private set; }

        /// <summary>Seconds to add to Unity's time for the scene's clock.</summary>
        public double ClockOffsetS { get; private set; }

        /// <summary>Processes the frames that are due.</summary>
        /// <param name="unityTimeS">Unity's time, seconds.</param>
        public void Update(double unityTimeS)
        {
            if (IsAtEnd)
                return;
            _lastUpdateS = unityTimeS;
            if (!_hasBegun)
                Begin(unityTimeS);
            double dueS = unityTimeS - _beganAtS + _latencyS;
            for (int i = 0; i < MaxFramesPerUpdate && _hasFrame && (_runner.Current.TimeUs - _firstTimeUs) * 1e-6 <= dueS; i++)
            {
                _runner.ProcessCurrent();
                _hasFrame = _runner.TryRead();
            }

            if (!_hasFrame)
                End();
        }

        /// <summary>Closes the session, if that is still to do, and the sources.</summary>
        public void Dispose()
        {
            End();
            _runner.Dispose();
            _screenCamera.Dispose();
            _handCamera?.Dispose();
        }

        private void Begin(double unityTimeS)
        {
            _hasBegun = true;
            _beganAtS = unityTimeS;
            _hasFrame = _runner.TryRead();
            _firstTimeUs = _runner.Current.TimeUs;
            // What is shown now is what the first frame saw and as much more as that frame took to get here.
            ClockOffsetS = (_firstTimeUs - (_sceneTimeZeroUs ?? _firstTimeUs)) * 1e-6 + _latencyS - unityTimeS;
        }

        private void End()
        {
            if (IsAtEnd)
                return;
            IsAtEnd = true;
            _pipeline.End(_hasBegun ? _lastUpdateS - _beganAtS : 0);
        }
    }
}
