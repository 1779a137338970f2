using System;
using System.Threading;
using LaserTracking.Capture;

namespace LaserTracking.Pipeline
{
    /// <summary>
    /// Runs recorded or simulated sources through a pipeline to their end: merges the two cameras by time, passes on what the
    /// sources found damaged. As fast as it can, unless a pace is given.
    /// </summary>
    public sealed class SessionRunner
    {
        private readonly RangePipeline _pipeline;
        private readonly IFrameSource _screenCamera;
        private readonly IFrameSource? _handCamera;
        private readonly long _handClockOffsetUs;
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
            _handClockOffsetUs = handClockOffsetUs;
        }

        /// <summary>Called before every frame of camera 0: the place for progress and pacing.</summary>
        public Action<Frame>? BeforeFrame { get; set; }

        /// <summary>Processes all frames; true when the end was reached, false when it was interrupted.</summary>
        public bool Run(CancellationToken interrupted)
        {
            using (var frame = new Frame())
            using (var handFrame = new Frame())
            {
                bool hasHandFrame = TryReadHands(handFrame);
                while (_screenCamera.TryRead(frame))
                {
                    if (interrupted.IsCancellationRequested)
                        return false;
                    while (hasHandFrame && handFrame.TimeUs <= frame.TimeUs)
                    {
                        _pipeline.ProcessHands(handFrame);
                        hasHandFrame = TryReadHands(handFrame);
                    }

                    BeforeFrame?.Invoke(frame);
                    _pipeline.Process(frame);
                    PassOnProblems(_screenCamera, ref _screenProblems);
                    if (_handCamera != null)
                        PassOnProblems(_handCamera, ref _handProblems);
                }

                PassOnProblems(_screenCamera, ref _screenProblems);
                return true;
            }
        }

        private bool TryReadHands(Frame frame)
        {
            if (_handCamera == null || !_handCamera.TryRead(frame))
                return false;
            frame.TimeUs += _handClockOffsetUs;
            frame.Depth.TimeUs += _handClockOffsetUs;
            return true;
        }

        private void PassOnProblems(IFrameSource source, ref int passedOn)
        {
            for (; passedOn < source.Problems.Count; passedOn++)
                _pipeline.ReportInputProblem(source.Problems[passedOn]);
        }
    }
}
