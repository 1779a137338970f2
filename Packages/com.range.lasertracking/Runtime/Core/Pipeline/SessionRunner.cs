using System;
using System.Threading;
using LaserTracking.Capture;

namespace LaserTracking.Pipeline
{
    /// <summary>
    /// Runs recorded or simulated sources through a pipeline to their end: merges the two cameras by time, passes on what the
    /// sources found damaged. <see cref="Run"/> goes as fast as it can, unless a pace is given; whoever has a clock of his own calls
    /// <see cref="TryRead"/> and <see cref="ProcessCurrent"/> in turn. The sources stay the caller's.
    /// </summary>
    public sealed class SessionRunner : IDisposable
    {
        private readonly RangePipeline _pipeline;
        private readonly IFrameSource _screenCamera;
        private IFrameSource? _handCamera;
        private LiveFrameSource? _liveHands;
        private readonly long _handClockOffsetUs;
        private readonly Frame _handFrame = new Frame();
        private bool _hasStarted;
        private bool _hasHandFrame;
        private bool _hasProcessed;
        private long _firstTimeUs;
        private int _screenProblems;
        private int _handProblems;

        /// <param name="pipeline">Already begun.</param>
        /// <param name="screenCamera">Camera 0.</param>
        /// <param name="handCamera">Camera 1, or null.</param>
        /// <param name="handClockOffsetUs">Added to camera 1's device times to bring them on camera 0's clock, microseconds.</param>
        public SessionRunner(RangePipeline pipeline, IFrameSource screenCamera, IFrameSource? handCamera, long handClockOffsetUs)
        {
            _pipeline = pipeline;
            _screenCamera = screenCamera;
            _handCamera = handCamera;
            _liveHands = handCamera as LiveFrameSource;
            _handClockOffsetUs = handClockOffsetUs;
        }

        /// <summary>Called before every frame of camera 0: the place for progress and pacing.</summary>
        public Action<Frame>? BeforeFrame { get; set; }

        /// <summary>Called with every frame of camera 1 as it comes, with its own clock's times: the place for recording.</summary>
        public Action<Frame>? HandFrameRead { get; set; }

        /// <summary>Called after every frame of camera 0: the place for statistics.</summary>
        public Action<Frame>? AfterFrame { get; set; }

        /// <summary>The frame of camera 0 that was read last.</summary>
        public Frame Current { get; } = new Frame();

        /// <summary>Whether a frame of camera 1 so far lies between the first and the current frame of camera 0.</summary>
        public bool HasHandsInTime { get; private set; }

        /// <summary>Processes all frames; true when the end was reached, false when it was interrupted.</summary>
        public bool Run(CancellationToken interrupted)
        {
            while (TryRead())
            {
                if (interrupted.IsCancellationRequested)
                    return false;
                ProcessCurrent();
            }

            // Ctrl-C also ends the programs that decode: their end is not the recording's.
            return !interrupted.IsCancellationRequested;
        }

        /// <summary>Reads the next frame of camera 0 without processing it; false at the end of the stream.</summary>
        public bool TryRead()
        {
            if (!_hasStarted)
            {
                _hasStarted = true;
                _hasHandFrame = TryReadHands(_handFrame);
            }

            if (_screenCamera.TryRead(Current))
                return true;
            PassOnProblems(_screenCamera, ref _screenProblems);
            return false;
        }

        /// <summary>Processes the current frame, before it what camera 1 saw until then.</summary>
        public void ProcessCurrent()
        {
            if (!_hasProcessed)
                _firstTimeUs = Current.TimeUs;
            _hasProcessed = true;
            if (!_hasHandFrame && _liveHands != null)
                _hasHandFrame = TryReadHands(_handFrame);
            while (_hasHandFrame && _handFrame.TimeUs - _pipeline.HandClockOffsetUs <= Current.TimeUs)
            {
                HasHandsInTime |= _handFrame.TimeUs >= _firstTimeUs;
                _pipeline.ProcessHands(_handFrame);
                _hasHandFrame = TryReadHands(_handFrame);
            }

            BeforeFrame?.Invoke(Current);
            _pipeline.Process(Current);
            AfterFrame?.Invoke(Current);
            PassOnProblems(_screenCamera, ref _screenProblems);
            if (_handCamera != null)
                PassOnProblems(_handCamera, ref _handProblems);
        }

        /// <summary>Camera 1 is there again, or for the first time: its frames go on from the next frame of camera 0.</summary>
        public void SetLiveHands(LiveFrameSource camera)
        {
            _handCamera = _liveHands = camera;
            _handProblems = 0;
        }

        public void Dispose()
        {
            Current.Dispose();
            _handFrame.Dispose();
        }

        private bool TryReadHands(Frame frame)
        {
            if (_handCamera == null || !(_liveHands == null ? _handCamera.TryRead(frame) : TryReadLive(_liveHands, frame)))
                return false;
            HandFrameRead?.Invoke(frame);
            frame.TimeUs += _handClockOffsetUs;
            frame.Depth.TimeUs += _handClockOffsetUs;
            return true;
        }

        /// <summary>A live camera 1 that falls silent must not hold up camera 0, nor end it when it breaks.</summary>
        private bool TryReadLive(LiveFrameSource hands, Frame frame)
        {
            try
            {
                return hands.TryReadNow(frame);
            }
            catch (InputException problem)
            {
                _handCamera = _liveHands = null;
                _pipeline.ReportInputProblem(new FrameProblem(-1, problem.Message));
                return false;
            }
        }

        private void PassOnProblems(IFrameSource source, ref int passedOn)
        {
            for (; passedOn < source.Problems.Count; passedOn++)
                _pipeline.ReportInputProblem(source.Problems[passedOn]);
        }
    }
}
