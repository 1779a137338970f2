using System;
using LaserTracking.Capture;
using LaserTracking.Pipeline;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Feeds a pipeline from Unity's clock: a frame is due when as much time has passed in Unity as in the source. The scene's clock
    /// is camera 0's, zero at its first frame.
    /// </summary>
    internal sealed class FramePump : IDisposable
    {
        // A machine that falls behind shall still draw: it catches up over several updates.
        private const int MaxFramesPerUpdate = 8;

        private readonly RangePipeline _pipeline;
        private readonly IFrameSource _screenCamera;
        private readonly IFrameSource? _handCamera;
        private readonly double _latencyS;
        private readonly Frame _frame = new Frame();
        private readonly Frame _handFrame = new Frame();
        private bool _hasBegun;
        private bool _hasFrame;
        private bool _hasHandFrame;
        private long _firstTimeUs;
        private double _beganAtS;
        private double _lastUpdateS;
        private int _screenProblems;
        private int _handProblems;

        /// <param name="pipeline">Already begun.</param>
        /// <param name="screenCamera">Camera 0; owned from now on.</param>
        /// <param name="handCamera">Camera 1, or null; owned from now on.</param>
        /// <param name="latencyS">From the light to the frame, seconds.</param>
        public FramePump(RangePipeline pipeline, IFrameSource screenCamera, IFrameSource? handCamera, double latencyS)
        {
            _pipeline = pipeline;
            _screenCamera = screenCamera;
            _handCamera = handCamera;
            _latencyS = latencyS;
        }

        /// <summary>The source has no more frames and the session is closed.</summary>
        public bool IsAtEnd { get; private set; }

        /// <summary>Seconds to add to Unity's time for the scene's clock.</summary>
        public double ClockOffsetS => _hasBegun ? _latencyS - _beganAtS : 0;

        /// <summary>Processes the frames that are due.</summary>
        /// <param name="unityTimeS">Unity's time, seconds.</param>
        public void Update(double unityTimeS)
        {
            _lastUpdateS = unityTimeS;
            if (!_hasBegun)
                Begin(unityTimeS);
            double dueS = unityTimeS + ClockOffsetS;
            for (int i = 0; i < MaxFramesPerUpdate && _hasFrame && (_frame.TimeUs - _firstTimeUs) * 1e-6 <= dueS; i++)
            {
                ProcessHandsUntil(_frame.TimeUs);
                _pipeline.Process(_frame);
                _hasFrame = _screenCamera.TryRead(_frame);
                PassOnProblems();
            }

            if (!_hasFrame)
                End();
        }

        /// <summary>Closes the session, if that is still to do, and the sources.</summary>
        public void Dispose()
        {
            End();
            _screenCamera.Dispose();
            _handCamera?.Dispose();
            _frame.Dispose();
            _handFrame.Dispose();
        }

        private void Begin(double unityTimeS)
        {
            _hasBegun = true;
            _beganAtS = unityTimeS;
            _hasFrame = _screenCamera.TryRead(_frame);
            _firstTimeUs = _frame.TimeUs;
            _hasHandFrame = _handCamera != null && _handCamera.TryRead(_handFrame);
            PassOnProblems();
        }

        private void End()
        {
            if (IsAtEnd)
                return;
            IsAtEnd = true;
            _pipeline.End(_hasBegun ? _lastUpdateS - _beganAtS : 0);
        }

        private void ProcessHandsUntil(long timeUs)
        {
            while (_hasHandFrame && _handFrame.TimeUs <= timeUs)
            {
                _pipeline.ProcessHands(_handFrame);
                _hasHandFrame = _handCamera!.TryRead(_handFrame);
            }
        }

        private void PassOnProblems()
        {
            for (; _screenProblems < _screenCamera.Problems.Count; _screenProblems++)
                _pipeline.ReportInputProblem(_screenCamera.Problems[_screenProblems]);
            for (; _handCamera != null && _handProblems < _handCamera.Problems.Count; _handProblems++)
                _pipeline.ReportInputProblem(_handCamera.Problems[_handProblems]);
        }
    }
}
