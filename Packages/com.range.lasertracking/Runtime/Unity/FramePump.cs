using System;
using System.Diagnostics;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Pipeline;
using LaserTracking.Session;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Runs a pipeline on a thread of its own. Frames of a recording or simulation are due when Unity's time has reached them; those of
    /// a live device when they come. The thread owns pipeline, sources and buffers and disposes them; Unity's thread tells it the time and
    /// never waits for it but in <see cref="CompleteDue"/> and, for a while, in <see cref="Dispose"/>.
    /// </summary>
    internal sealed class FramePump : IDisposable
    {
        /// <summary>How long the thread may take to end; a driver that hangs must not hang Unity.</summary>
        private const int StopTimeoutMs = 3000;

        private readonly object _lock = new object();
        private readonly RangePipeline _pipeline;
        private readonly IFrameSource _screenCamera;
        private IFrameSource? _handCamera;
        private LiveFrameSource? _newHands;
        private readonly SessionRunner _runner;
        private readonly SceneClock _clock;
        private readonly IDisposable? _handModel;
        private readonly EventInbox _events;
        private readonly bool _isLive;
        private readonly Stopwatch _running = Stopwatch.StartNew();
        private readonly Thread _thread;
        private long? _sceneTimeZeroUs;
        private long _newestUs;
        private bool _hasFrame;
        private bool _isWaiting;
        private bool _isStopping;
        private bool _hasEnded;
        private bool _hasFailed;
        private long _dueUs = long.MinValue;
        private long _toldDropped;
        private Action<Frame>? _look;
        private volatile SessionLogWriter? _recording;

        /// <param name="pipeline">Already begun; used by the thread alone from now on.</param>
        /// <param name="screenCamera">Camera 0; owned from now on.</param>
        /// <param name="handCamera">Camera 1 or null; owned from now on.</param>
        /// <param name="handClockOffsetUs">Brings camera 1's times on camera 0's clock.</param>
        /// <param name="source">Where they come from: says what kind of clock they have.</param>
        /// <param name="handModel">Used by the pipeline; owned from now on. Or null.</param>
        /// <param name="events">Where the pipeline's events go; what befalls the sources goes there too.</param>
        /// <param name="recording">Records what the detector gets; stays the caller's. Or null.</param>
        /// <param name="look">See <see cref="Look"/>; from the first frame on.</param>
        /// <param name="pictures">What the projector shows, delivered before each frame; or null.</param>
        public FramePump(RangePipeline pipeline, IFrameSource screenCamera, IFrameSource? handCamera, long handClockOffsetUs, FrameSourceAsset source,
            IDisposable? handModel, EventInbox events, SessionLogWriter? recording, Action<Frame>? look, PictureInbox? pictures)
        {
            _pipeline = pipeline;
            _screenCamera = screenCamera;
            _handCamera = handCamera;
            _runner = new SessionRunner(pipeline, screenCamera, handCamera, handClockOffsetUs);
            _sceneTimeZeroUs = source.SceneTimeZeroUs;
            _isLive = source.IsLive;
            _clock = new SceneClock(_isLive, source.LatencyS);
            _handModel = handModel;
            _events = events;
            _look = look;
            _recording = recording;
            _runner.BeforeFrame = frame =>
            {
                pictures?.Deliver();
                _recording?.AddScreenFrame(frame);
            };
            _runner.HandFrameRead = frame => _recording?.AddHandFrame(frame);
            _thread = new Thread(Run) { IsBackground = true, Name = "laser detection of " + screenCamera.Info.Name };
            _thread.Start();
        }

        /// <summary>The source has no more frames and the session is closed; its last events may still wait.</summary>
        public bool IsAtEnd
        {
            get
            {
                lock (_lock)
                    return _hasEnded;
            }
        }

        /// <summary>It ended because something broke, and that was said.</summary>
        public bool HasFailed
        {
            get
            {
                lock (_lock)
                    return _hasFailed;
            }
        }

        /// <summary>Camera 1 is not there, or gives no more frames.</summary>
        public bool HasNoHands
        {
            get
            {
                lock (_lock)
                    return _newHands == null && (_handCamera == null || (_handCamera as LiveFrameSource)?.HasEnded == true);
            }
        }

        /// <summary>Takes camera 1, which was not there; owned from now on.</summary>
        public void SetHands(LiveFrameSource camera)
        {
            lock (_lock)
                _newHands = camera;
        }

        /// <summary>Seconds to add to Unity's time for the scene's clock.</summary>
        public double ClockOffsetS => _clock.OffsetS;

        /// <summary>
        /// While set, frames of camera 0 go there and not to the detector: called on the detector's thread, which it may hold up.
        /// </summary>
        public Action<Frame>? Look
        {
            set
            {
                lock (_lock)
                    _look = value;
            }
        }

        /// <summary>From the next frame on nothing is recorded.</summary>
        public void StopRecording() => _recording = null;

        /// <summary>Seconds on the scene's clock of a time on camera 0's; after the first frame.</summary>
        public double ToSceneTimeS(long timeUs)
        {
            lock (_lock)
                return (timeUs - (_sceneTimeZeroUs ?? 0)) * 1e-6;
        }

        /// <summary>Microseconds on camera 0's clock at a time on Unity's; null before the first frame.</summary>
        public long? ToCameraTimeUs(double unityTimeS)
        {
            lock (_lock)
                return _clock.HasBegun ? (long)Math.Round((unityTimeS + _clock.OffsetS) * 1e6) + _sceneTimeZeroUs!.Value : (long?)null;
        }

        /// <summary>Tells the thread what time it is. Does not wait.</summary>
        /// <param name="unityTimeS">Unity's time, seconds.</param>
        public void Update(double unityTimeS)
        {
            TellDropped();
            lock (_lock)
            {
                if (!_hasFrame || _hasEnded)
                    return;
                double newestS = (_newestUs - _sceneTimeZeroUs!.Value) * 1e-6;
                if (_clock.HasBegun)
                    _clock.Advance(unityTimeS, newestS, !_isWaiting);
                else
                    _clock.Begin(unityTimeS, newestS);
                // Rounded: the sums of many small time steps must not miss a frame by the last bit.
                _dueUs = (long)Math.Round(_clock.TimeS * 1e6) + _sceneTimeZeroUs.Value;
                Monitor.PulseAll(_lock);
            }
        }

        /// <summary>Waits until every frame that is due has been processed; at once for a live source, whose frames are never due.</summary>
        public void CompleteDue()
        {
            lock (_lock)
            {
                while (!_isLive && !_hasEnded && !_isWaiting)
                    Monitor.Wait(_lock);
                // It may wait for a time that has come meanwhile.
                while (!_isLive && !_hasEnded && _newestUs <= _dueUs)
                    Monitor.Wait(_lock);
            }
        }

        /// <summary>Closes the session, if that is still to do, and the sources.</summary>
        public void Dispose()
        {
            lock (_lock)
            {
                _isStopping = true;
                Monitor.PulseAll(_lock);
            }

            (_screenCamera as LiveFrameSource)?.Stop();
            (_screenCamera as PushedFrameSource)?.Close();
            if (!_thread.Join(StopTimeoutMs))
                Say(HealthKind.SetUp, "camera " + _screenCamera.Info.Name + " does not answer; it is left to itself until it does: unplug it and plug it in again");
        }

        private void Run()
        {
            try
            {
                while (TryReadNext())
                    Process();
            }
            catch (InputException problem)
            {
                Fail(problem.Message);
            }
            catch (Exception problem)
            {
                Fail("the detector has stopped: " + problem);
            }

            try
            {
                _pipeline.End(_running.Elapsed.TotalSeconds);
                _runner.Dispose();
                _handModel?.Dispose();
                _handCamera?.Dispose();
                _newHands?.Dispose();
                _screenCamera.Dispose();
            }
            catch (Exception problem)
            {
                Fail("closing the cameras failed: " + problem);
            }

            lock (_lock)
            {
                _hasEnded = true;
                Monitor.PulseAll(_lock);
            }
        }

        /// <summary>Reads a frame and waits until it is due; false at the end.</summary>
        private bool TryReadNext()
        {
            if (IsStopping || !_runner.TryRead())
                return false;
            lock (_lock)
            {
                _newestUs = _runner.Current.TimeUs;
                _sceneTimeZeroUs ??= _newestUs;
                _hasFrame = true;
                while (!_isLive && !_isStopping && _newestUs > _dueUs)
                {
                    _isWaiting = true;
                    Monitor.PulseAll(_lock);
                    Monitor.Wait(_lock);
                }

                _isWaiting = false;
                return !_isStopping;
            }
        }

        private bool IsStopping
        {
            get
            {
                lock (_lock)
                    return _isStopping;
            }
        }

        private void Process()
        {
            Action<Frame>? look;
            lock (_lock)
            {
                look = _look;
                TakeNewHands();
            }

            if (look == null)
                _runner.ProcessCurrent();
            else
                look(_runner.Current);
        }

        private void TakeNewHands()
        {
            if (_newHands == null)
                return;
            // It has ended, so that this does not wait.
            _handCamera?.Dispose();
            _handCamera = _newHands;
            _runner.SetLiveHands(_newHands);
            _newHands = null;
        }

        /// <summary>Once for each time that it doubles: a machine that is too slow must not fill the Console.</summary>
        private void TellDropped()
        {
            long dropped = _screenCamera is LiveFrameSource live ? live.Dropped : _screenCamera is PushedFrameSource pushed ? pushed.Dropped : 0;
            if (dropped == 0 || dropped < 2 * _toldDropped)
                return;
            _toldDropped = dropped;
            Say(HealthKind.FrameGap, FormattableString.Invariant($"{dropped} frames of {_screenCamera.Info.Name} were left out because the detector did not keep up; shots in them are lost: close other programs or lower the camera's resolution"), dropped);
        }

        private void Fail(string text)
        {
            lock (_lock)
                _hasFailed = true;
            Say(HealthKind.SetUp, text);
        }

        private void Say(HealthKind kind, string text, double value = 0)
        {
            var health = new HealthEvent { FrameIndex = -1, Kind = kind, Value = value, Text = text };
            _events.OnHealth(health);
        }
    }
}
