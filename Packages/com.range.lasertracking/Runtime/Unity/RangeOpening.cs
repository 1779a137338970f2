using System;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Kernels;
using LaserTracking.Pipeline;
using LaserTracking.Session;

namespace LaserTracking.Unity
{
    /// <summary>Opens what a <see cref="LaserRange"/> names, sources, calibration and hand model, and sets the pipeline going. Main thread.</summary>
    internal sealed class RangeOpening
    {
        private const double SizeToleranceM = 0.005;

        private readonly LaserRange _range;
        private readonly FrameSourceAsset _asset;
        private readonly FrameSourceAsset? _handAsset;
        private readonly Action<string> _warn;

        /// <param name="range">To be opened.</param>
        /// <param name="asset">Its source.</param>
        /// <param name="handAsset">Camera 1's own; null: the source's camera 1, if it has one.</param>
        /// <param name="warn">Told what is missing although it opens.</param>
        public RangeOpening(LaserRange range, FrameSourceAsset asset, FrameSourceAsset? handAsset, Action<string> warn)
        {
            _range = range;
            _asset = asset;
            _handAsset = handAsset;
            _warn = warn;
        }

        /// <summary>Shots will have a place on the screen.</summary>
        public bool HasCalibration { get; private set; }

        /// <summary>Camera 1 could be opened.</summary>
        public bool HasHands { get; private set; }

        /// <summary>Camera 1 may be plugged in later.</summary>
        public bool WantsHands { get; private set; }

        /// <param name="events">Where what it finds goes.</param>
        /// <param name="look">Takes the frames instead of the detector; or null.</param>
        /// <exception cref="InputException">The source or its calibration cannot be used; nothing stays open.</exception>
        public FramePump Open(EventInbox events, Action<Frame>? look)
        {
            IFrameSource? source = null, handSource = null;
            HandLandmarkNetwork? handModel = null;
            try
            {
                source = OnThread(_asset.CreateSource(_range), _asset);
                RangeCalibration? calibration = ReadCalibration();
                HasCalibration = calibration != null;
                if (calibration?.HandCamera != null)
                    handSource = OpenHandSource();
                HasHands = handSource != null;
                WantsHands = calibration?.HandCamera != null && _handAsset != null && _handAsset.IsLive;
                long handClockOffsetUs = handSource == null && !WantsHands ? 0 : _handAsset == null ? _asset.HandClockOffsetUs : _handAsset.ClockOffsetUs;
                KernelRunner kernels = RangeKernels.Create();
                handModel = handSource == null && !WantsHands ? null : OpenHandModel(kernels);
                var settings = new PipelineSettings { SceneTimeZeroUs = _asset.SceneTimeZeroUs };
                SessionLogWriter? recording = _range.Recorder?.Begin(_asset, source, handSource, handClockOffsetUs, calibration);
                IEventSink sink = recording?.Events == null ? (IEventSink)events : new EventSinkGroup(new IEventSink[] { recording.Events, events });
                // No scorer: rays are cast by Unity's physics, which only its own thread may ask.
                PictureInbox? pictures = calibration == null || !_asset.IsLive ? null : _range.Pictures?.Begin();
                ExpectedView? expected = pictures == null ? null : new ExpectedView(pictures.History, calibration!, _range.Pictures!.Settings(), kernels);
                RangePipeline pipeline = RangePipeline.CreateDefault(new ShotDetector(null, expected, kernels), calibration, handSource != null || WantsHands, null, sink, settings, handModel, kernels);
                pipeline.Begin(new SessionHeader(PackageVersion.Text, Array.Empty<SessionInput>(), null, "shots", null));
                return new FramePump(pipeline, source, handSource, handClockOffsetUs, _asset, handModel, events, recording, look, pictures);
            }
            catch
            {
                _range.Recorder?.End(false);
                _asset.ReleaseSource();
                source?.Dispose();
                handSource?.Dispose();
                handModel?.Dispose();
                throw;
            }
        }

        /// <summary>A device is read on a thread of its own, so that frames never wait in its driver.</summary>
        internal static IFrameSource OnThread(IFrameSource source, FrameSourceAsset asset) =>
            asset.IsLive && !(source is PushedFrameSource) ? new LiveFrameSource(source) : source;

        /// <summary>Without it the range works, but nobody knows who fired.</summary>
        private IFrameSource? OpenHandSource()
        {
            FrameSourceAsset? asset = _handAsset;
            try
            {
                IFrameSource? source = asset == null ? _asset.CreateHandSource() : asset.CreateSource(_range);
                return source == null ? null : OnThread(source, asset == null ? _asset : asset);
            }
            catch (InputException problem)
            {
                if (asset != null)
                    asset.ReleaseSource();
                _warn(problem.Message + (asset != null && asset.IsLive ? "; until it is there nobody knows who fires" : "; until the range is switched off and on again nobody knows who fires"));
                return null;
            }
        }

        /// <summary>Without its file hands are found by depth alone.</summary>
        private HandLandmarkNetwork? OpenHandModel(KernelRunner kernels)
        {
            if (_range.HandModelFile.Length == 0)
                return null;
            try
            {
                string file = UserPath.Under("", _range.HandModelFile);
                return HandLandmarkNetwork.Open(file, HandModelFile.ByName(file), kernels);
            }
            catch (InputException problem)
            {
                _warn(problem.Message + "; hands are found by depth alone");
                return null;
            }
        }

        private RangeCalibration? ReadCalibration()
        {
            ScreenSurface? screen = _range.Screen;
            if (screen == null)
                return null;
            RangeCalibration? calibration = screen.ReadCalibration() ?? _asset.Calibration;
            if (calibration == null)
            {
                _warn("LaserRange " + _range.name + ": the screen has no calibration, so shots have no place on it and cannot hit anything; calibrate it, or drag the calibration of camera 0 into the ScreenSurface");
                return null;
            }

            Vector2D off = calibration.Screen.ScreenSizeM - screen.SizeM;
            if (screen.HasSize && off.Length > SizeToleranceM)
                _warn("LaserRange " + _range.name + ": the calibrated picture is " + calibration.Screen.ScreenSizeM + " m, the ScreenSurface " + screen.SizeM + " m, so shots land beside what was aimed at; set one to the other");
            if (_handAsset != null && calibration.HandCamera == null)
                _warn("LaserRange " + _range.name + ": the calibration does not say where camera 1 stands, so its frames are not used; calibrate both cameras");
            return calibration;
        }
    }
}
