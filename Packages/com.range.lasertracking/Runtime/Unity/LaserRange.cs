using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Kernels;
using LaserTracking.Pipeline;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The range itself: reads frames, finds shots in them, casts them through the screen into the scene and tells who wants to
    /// know. Runs before other components, so that targets move by the clock it sets.
    /// </summary>
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-100)]
    [AddComponentMenu("Laser Tracking/Laser Range")]
    public sealed class LaserRange : MonoBehaviour
    {
        private const double SizeToleranceM = 0.005;

        [SerializeField]
        private ScreenSurface? _screen;

        [SerializeField]
        [Tooltip("Eye from which the picture on the screen is drawn, in front of the screen. Usually the camera.")]
        private Transform? _viewpoint;

        [SerializeField]
        [Tooltip("Layers that shots can hit.")]
        private LayerMask _hitLayers = ~0;

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
        [Tooltip("Called for every shot, hit or miss.")]
        private UnityEvent<ShotEvent> _shotFired = new UnityEvent<ShotEvent>();

        private FramePump? _pump;
        private ShotQueue? _shots;
        private PhysicsRaycaster? _raycaster;
        private HandLandmarkNetwork? _handModel;
        private bool _isOpen;

        /// <summary>Raised on the main thread for every shot, hit or miss, in the order of the shots.</summary>
        public event Action<ShotEvent>? ShotFired;

        /// <summary>True while the source still has frames.</summary>
        public bool IsRunning => _pump != null && !_pump.IsAtEnd;

        internal ScreenSurface? Screen => _screen;

        internal Transform? Viewpoint => _viewpoint;

        internal int HitLayers => _hitLayers;

        private void OnEnable() => _isOpen = false;

        private void OnDisable()
        {
            _pump?.Dispose();
            RaiseShots();
            _pump = null;
            _handModel?.Dispose();
            _handModel = null;
        }

        // The sources open here and not in OnEnable: by now every other component of the scene is awake.
        private void Update()
        {
            if (!_isOpen)
            {
                _isOpen = true;
                Open();
            }

            if (_pump == null)
                return;
            _pump.Update(Time.timeAsDouble);
            for (int i = 0; i < MovingTargets.Count; i++)
                MovingTargets.At(i).ClockOffsetS = _pump.ClockOffsetS;
            RaiseShots();
        }

        private void Open()
        {
            if (_source == null)
            {
                Debug.LogWarning("LaserRange " + name + " has no source of frames: drag a frame source asset in", this);
                return;
            }

            IFrameSource? source = null, handSource = null;
            try
            {
                source = _source.CreateSource(this);
                RangeCalibration? calibration = ReadCalibration(_source);
                if (calibration?.HandCamera != null)
                    handSource = _handSource == null ? _source.CreateHandSource() : _handSource.CreateSource(this);
                long handClockOffsetUs = handSource == null ? 0 : _handSource == null ? _source.HandClockOffsetUs : _handSource.ClockOffsetUs;
                _shots = new ShotQueue(this);
                KernelRunner kernels = RangeKernels.Create();
                _handModel = handSource == null ? null : OpenHandModel(kernels);
                var settings = new PipelineSettings { SceneTimeZeroUs = _source.SceneTimeZeroUs };
                RangePipeline pipeline = RangePipeline.CreateDefault(new ShotDetector(null, null, kernels), calibration, handSource != null, BuildScorer(), _shots, settings, _handModel, kernels);
                pipeline.Begin(new SessionHeader(PackageVersion.Text, Array.Empty<SessionInput>(), null, "shots", null));
                _pump = new FramePump(pipeline, source, handSource, handClockOffsetUs, _source.SceneTimeZeroUs, _source.LatencyS);
            }
            catch (InputException problem)
            {
                source?.Dispose();
                handSource?.Dispose();
                Debug.LogError(problem.Message, this);
            }
        }

        /// <summary>Without its file hands are found by depth alone.</summary>
        private HandLandmarkNetwork? OpenHandModel(KernelRunner kernels)
        {
            if (_handModelFile.Length == 0)
                return null;
            try
            {
                return HandLandmarkNetwork.Open(_handModelFile, HandModelFile.ByName(_handModelFile), kernels);
            }
            catch (InputException problem)
            {
                Debug.LogWarning(problem.Message + "; hands are found by depth alone", this);
                return null;
            }
        }

        private ShotScorer? BuildScorer()
        {
            if (_screen == null || _viewpoint == null)
            {
                Debug.LogWarning("LaserRange " + name + " has no " + (_screen == null ? "screen" : "viewpoint") + ": shots cannot hit anything; drag one in", this);
                return null;
            }

            _raycaster = new PhysicsRaycaster(_hitLayers);
            return new ShotScorer(_raycaster, _screen.Pose, _screen.SizeM, _viewpoint.position.ToCore());
        }

        private RangeCalibration? ReadCalibration(FrameSourceAsset source)
        {
            if (_screen == null)
                return null;
            string? text = _screen.CalibrationText;
            RangeCalibration? calibration = text == null ? source.Calibration : RangeCalibrationFile.Parse(text, "calibration of " + _screen.name);
            if (calibration == null)
            {
                Debug.LogWarning("LaserRange " + name + ": the screen has no calibration, so shots have no place on it and cannot hit anything; drag the calibration of camera 0 into the ScreenSurface", this);
                return null;
            }

            Vector2D off = calibration.Screen.ScreenSizeM - _screen.SizeM;
            if (off.Length > SizeToleranceM)
                Debug.LogWarning("LaserRange " + name + ": the calibrated picture is " + calibration.Screen.ScreenSizeM + " m, the ScreenSurface " + _screen.SizeM + " m, so shots land beside what was aimed at; set one to the other", this);
            if (_handSource != null && calibration.HandCamera == null)
                Debug.LogWarning("LaserRange " + name + ": the calibration does not say where camera 1 stands, so its frames are not used; calibrate both cameras", this);
            return calibration;
        }

        private void RaiseShots()
        {
            while (_shots != null && _shots.TryTake(out ShotEvent shot))
            {
                ShotFired?.Invoke(shot);
                _shotFired.Invoke(shot);
                if (shot.HasHit && _raycaster != null && _raycaster.TryFindTarget(shot.Hit.Target, out LaserTarget? target))
                    target!.ReportHit(shot);
            }
        }
    }
}
