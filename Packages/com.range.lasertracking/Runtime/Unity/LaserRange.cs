using System;
using System.IO;
using LaserTracking.Capture;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The range itself: frames are read and shots found in them on threads of their own; here they are cast through the screen into
    /// the scene, and who wants to know is told. Runs before other components, so that targets move by the clock it sets.
    /// </summary>
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-100)]
    [AddComponentMenu("Laser Tracking/Laser Range")]
    public sealed class LaserRange : ShotEmitter
    {
        /// <summary>A live camera that is not there is tried again after so many seconds.</summary>
        private const double RetryS = 2;

        [SerializeField]
        [Tooltip("Where the frames of camera 0, the one that sees the screen, come from.")]
        private FrameSourceAsset? _source;

        [SerializeField]
        [Tooltip("Where the depth frames of camera 1, the one that sees the trainees, come from, unless the source above has them too. Without them nobody knows who fired.")]
        private FrameSourceAsset? _handSource;

        [SerializeField]
        [Tooltip("Path of hand_landmark_lite.tflite or hand_landmark_full.tflite: sharpens palms and sides where camera 1 has infrared. Empty: depth alone.")]
        private string _handModelFile = "";

        [SerializeField]
        [Tooltip("Called for every dot that a laser shows in the newest frame.")]
        private UnityEvent<DotEvent> _dotMoved = new UnityEvent<DotEvent>();

        [SerializeField]
        [Tooltip("Called for every hand in camera 1's newest frame.")]
        private UnityEvent<HandEvent> _handMoved = new UnityEvent<HandEvent>();

        private readonly DotEvent[] _dots = new DotEvent[EventInbox.LatestCapacity];
        private readonly HandEvent[] _hands = new HandEvent[EventInbox.LatestCapacity];
        private readonly EventInbox _events = new EventInbox();
        private FramePump? _pump;
        private FrameSourceAsset? _handsInUse;
        private Action<Frame>? _look;
        private bool _isOpen;
        private bool _isLost;
        private bool _isPrepared;
        private bool _wantsHands;
        private bool _hasNoHands;
        private double _retryAtS;
        private double _handRetryAtS;

        /// <summary>Raised for every dot of the newest frame since the last Update; older frames' are passed over.</summary>
        public event Action<DotEvent>? DotMoved;

        /// <summary>The same for the hands of camera 1.</summary>
        public event Action<HandEvent>? HandMoved;

        /// <summary>True while the source still has frames.</summary>
        public bool IsRunning => _pump != null && !_pump.IsAtEnd;

        /// <summary>Where camera 0's frames come from; another one plays from the next Update on.</summary>
        public FrameSourceAsset? Source
        {
            get => _source == null ? null : _source;
            set
            {
                Close();
                _source = value;
            }
        }

        /// <summary>Where camera 1's frames come from; another one plays from the next Update on.</summary>
        public FrameSourceAsset? HandSource
        {
            get => _handSource == null ? null : _handSource;
            set
            {
                Close();
                _handSource = value;
            }
        }

        internal string HandModelFile => _handModelFile;

        internal double SceneClockOffsetS => _pump?.ClockOffsetS ?? 0;

        private protected override double ClockOffsetS => SceneClockOffsetS;

        /// <summary>Records what the detector gets, when there is one.</summary>
        internal RangeRecorder? Recorder { get; private set; }

        /// <summary>Tells what the projector shows, when somebody does.</summary>
        internal RenderedPictures? Pictures { get; private set; }

        /// <summary>Now on camera 0's clock, microseconds; null before the first frame.</summary>
        internal long? CameraTimeUs => _pump?.ToCameraTimeUs(Time.timeAsDouble);

        /// <summary>
        /// Waits until all frames that are due have been processed and raises their events: for tests and replays that must see the same
        /// in every frame. Without it Unity's thread waits for nobody, and an event comes with the Update after its frame is done.
        /// </summary>
        public void CompleteDueFrames()
        {
            WaitForDueFrames();
            RaiseEvents();
        }

        internal void WaitForDueFrames()
        {
            if (_pump == null)
                return;
            _pump.CompleteDue();
            // Its first frame may have come only now, and with it the clock.
            TellTime(_pump);
            _pump.CompleteDue();
        }

        /// <summary>Opens source and calibration anew, in the next Update.</summary>
        public void Restart() => Close();

        /// <summary>From the next opening on; what is open already is opened anew.</summary>
        internal void AttachRecorder(RangeRecorder recorder)
        {
            Recorder = recorder;
            if (_pump != null)
                Restart();
        }

        /// <summary>From the next opening on, as with a recorder; null: nobody tells any more.</summary>
        internal void AttachPictures(RenderedPictures? pictures)
        {
            Pictures = pictures;
            if (_pump != null)
                Restart();
        }

        /// <summary>The recorder gets no more frames, and the hits of all shots so far; the range goes on.</summary>
        internal void DetachFrames()
        {
            _pump?.StopRecording();
            RaiseShots();
        }

        /// <summary>The source has ended, and every shot has been told.</summary>
        internal bool HasToldAll => !IsRunning && !_events.HasShots;

        private protected override void OnScored(in ShotEvent shot)
        {
            if (Recorder != null)
                Recorder.AddScored(shot);
        }

        /// <summary>While set, camera 0's frames go there instead of to the detector, on the detector's thread.</summary>
        internal void SetLook(Action<Frame>? look)
        {
            _look = look;
            if (_pump != null)
                _pump.Look = look;
        }

        private void OnEnable()
        {
            ShotEmitters.Add(this);
            _isOpen = _isLost = _isPrepared = false;
        }

        private void OnDisable()
        {
            Close();
            ShotEmitters.Remove(this);
        }

        // The sources open here and not in OnEnable: by now every other component of the scene is awake.
        private void Update()
        {
            if (!_isOpen || (_isLost && Time.timeAsDouble >= _retryAtS))
                Open();
            if (_pump != null)
            {
                _source!.UpdateSource();
                if (_handsInUse != null)
                    _handsInUse.UpdateSource();
                TellTime(_pump);
            }

            RaiseEvents();
            if (_pump != null && _source!.IsLive && _pump.IsAtEnd)
                Lose(_pump);
            if (_pump != null && _wantsHands && _pump.HasNoHands)
                LookForHands(_pump);
        }

        private void TellTime(FramePump pump)
        {
            pump.Update(Time.timeAsDouble);
            for (int i = 0; i < MovingTargets.Count; i++)
                MovingTargets.At(i).ClockOffsetS = pump.ClockOffsetS;
        }

        private void Open()
        {
            bool isRetry = _isOpen;
            _isOpen = true;
            _isLost = false;
            LaserRange? other = _source == null ? null : OtherRangeWith(_source);
            if (_source == null)
            {
                Report("LaserRange " + name + " has no source of frames: drag a frame source asset in", false);
                return;
            }

            if (other != null)
            {
                Report("LaserRange " + name + ": its source " + _source.name + " already serves LaserRange " + other.name + ", and one camera can serve only one; give this one another source or disable it", true);
                return;
            }

            _handsInUse = UsableHands();
            var opening = new RangeOpening(this, _source, _handsInUse, Warn);
            try
            {
                _pump = opening.Open(_events, _look);
                _wantsHands = opening.WantsHands;
                _hasNoHands = !opening.HasHands;
                _handRetryAtS = Time.timeAsDouble + RetryS;
                if (isRetry)
                    Report("LaserRange " + name + ": the camera of " + _source.name + " is there again", false);
                if (!_isPrepared)
                    SwitchOnDisplay();
                if (!_isPrepared && (Screen == null || opening.HasCalibration))
                    PrepareCasting();
                _isPrepared = true;
            }
            catch (InputException problem)
            {
                if (!isRetry)
                    Report(problem.Message, true);
                WaitForCamera();
            }
            catch (Exception problem) when (problem is TypeLoadException || problem is FileNotFoundException || problem is BadImageFormatException)
            {
                Report("LaserRange " + name + ": the source " + _source.name + " needs a library that is not there or does not fit (" + problem.Message + "); install it, or choose another source", true);
            }
        }

        /// <summary>A hand source that something else reads already is left to that; who fires is then not known.</summary>
        private FrameSourceAsset? UsableHands()
        {
            if (_handSource == null)
                return null;
            LaserRange? other = OtherRangeWith(_handSource);
            if (other == null && _handSource != _source)
                return _handSource;
            Warn("LaserRange " + name + ": its hand source " + _handSource.name + (other != null ? " already serves LaserRange " + other.name : " is its source too")
                + ", and one camera can serve only once, so nobody knows who fires; drag in the asset of the camera that sees the trainees, or none");
            return null;
        }

        /// <summary>A player switches on none but the first by itself.</summary>
        private void SwitchOnDisplay()
        {
            if (Camera is Camera camera && !OutputDisplay.TrySwitchOn(camera.targetDisplay))
                Report("LaserRange " + name + ": " + camera.name + " draws on display " + (camera.targetDisplay + 1) + ", which is not plugged in, so nobody sees its picture; plug the projector in and start anew, or set Target Display of the camera", true);
        }

        /// <summary>What is missing is said once, however often a camera comes back.</summary>
        private void Warn(string text)
        {
            if (!_isPrepared)
                Report(text, false);
        }

        private void Lose(FramePump pump)
        {
            if (!pump.HasFailed)
                Report("LaserRange " + name + ": the camera of " + _source!.name + " gives no more pictures; check its cable, it is looked for every " + RetryS + " seconds", true);
            ClosePump();
            WaitForCamera();
        }

        /// <summary>Camera 1 is looked for while camera 0 plays on.</summary>
        private void LookForHands(FramePump pump)
        {
            FrameSourceAsset asset = _handsInUse!;
            if (!_hasNoHands)
            {
                _hasNoHands = true;
                _handRetryAtS = Time.timeAsDouble + RetryS;
                Report("LaserRange " + name + ": camera 1, " + asset.name + ", gives no more pictures, so nobody knows who fires; check its cable, it is looked for every " + RetryS + " seconds", true);
            }

            if (Time.timeAsDouble < _handRetryAtS)
                return;
            _handRetryAtS = Time.timeAsDouble + RetryS;
            asset.ReleaseSource();
            try
            {
                if (RangeOpening.OnThread(asset.CreateSource(this), asset) is LiveFrameSource camera)
                {
                    pump.SetHands(camera);
                    _hasNoHands = false;
                    Report("LaserRange " + name + ": camera 1, " + asset.name + ", is there again", false);
                }
            }
            catch (InputException)
            {
                // Still not there, which was said.
            }
        }

        private void WaitForCamera()
        {
            _isLost = _source!.IsLive;
            _retryAtS = Time.timeAsDouble + RetryS;
        }

        private void Close()
        {
            ClosePump();
            RaiseEvents();
            _isOpen = _isLost = _isPrepared = false;
        }

        private void ClosePump()
        {
            if (_pump == null)
                return;
            _source!.ReleaseSource();
            if (_handsInUse != null)
                _handsInUse.ReleaseSource();
            _handsInUse = null;
            _pump.Dispose();
            RaiseEvents();
            _pump = null;
            if (Recorder != null)
                Recorder.End(true);
        }

        private LaserRange? OtherRangeWith(FrameSourceAsset source)
        {
            for (int i = 0; i < ShotEmitters.Count; i++)
            {
                if (ShotEmitters.At(i) is LaserRange other && other != this && other._pump != null && (other._source == source || other._handsInUse == source))
                    return other;
            }

            return null;
        }

        private void RaiseShots()
        {
            while (_pump != null && _events.TryTakeShot(out ShotEvent shot))
                Emit(shot, _pump.ToSceneTimeS(shot.Shot.TimeUs));
        }

        private void RaiseEvents()
        {
            RaiseShots();
            int dots = _events.TakeDots(_dots), hands = _events.TakeHands(_hands);
            for (int i = 0; i < dots; i++)
                Raise(DotMoved, _dotMoved, _dots[i]);
            for (int i = 0; i < hands; i++)
                Raise(HandMoved, _handMoved, _hands[i]);
            while (_events.TryTakeHealth(out HealthEvent health))
            {
                ShotEmitters.Log(this, health.FrameIndex < 0 ? health.Text : "Laser range, frame " + health.FrameIndex + ": " + health.Text, health.Kind == HealthKind.SetUp);
                AddHealth(health);
            }

            RaiseHealth();
        }
    }
}
