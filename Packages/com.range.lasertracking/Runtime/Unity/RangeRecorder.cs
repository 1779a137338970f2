using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using LaserTracking.Capture;
using LaserTracking.Capture.Recording;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Records what a <see cref="LaserRange"/> sees and finds: both cameras' frames as the detector gets them, calibration, scene and the
    /// poses of what moves, events, in a folder that './range replay' runs again. Writing has threads of its own; with cameras, a disk that
    /// does not keep up costs frames of the recording, which is said, never the game or a shot.
    /// </summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(LaserRange))]
    [DefaultExecutionOrder(1000)]
    [AddComponentMenu("Laser Tracking/Range Recorder")]
    public sealed class RangeRecorder : MonoBehaviour
    {
        private const int MaxSessions = 100000;

        [SerializeField]
        [Tooltip("Folder that gets a folder for each session. A relative path begins in Unity's persistent data path.")]
        private string _folder = "Sessions";

        [SerializeField]
        [Tooltip("Records whenever the range runs. Off: from StartRecording to StopRecording.")]
        private bool _recordsAlways = true;

        [SerializeField]
        [Tooltip("Keeps only the part of camera 0's pictures that shows the calibrated screen, every bit of it: a fraction of the disk space.")]
        private bool _screenOnly;

        [SerializeField]
        [Tooltip("1 to 100: camera 0's pictures as JPEG, small but not the same to the bit. 0: every bit is kept.")]
        [Range(0, 100)]
        private int _jpegQuality;

        [SerializeField]
        [Tooltip("Camera 1's frames too.")]
        private bool _recordsHands = true;

        private LaserRange? _range;
        private readonly Stopwatch _running = new Stopwatch();
        private SessionLogWriter? _writer;
        private MovedObjects _moved = MovedObjects.None;
        private bool _isWanted;
        private long _toldLost;
        private bool _isToldProblem;

        /// <summary>A session is being written.</summary>
        public bool IsRecording => _writer != null;

        /// <summary>Folder of the session that is being written, or was last; empty before the first.</summary>
        public string SessionFolder { get; private set; } = "";

        /// <summary>Frames of camera 0 in the file so far.</summary>
        public long RecordedFrames => _writer?.RecordedFrames ?? 0;

        /// <summary>Frames of this session that could not be written.</summary>
        public long LostFrames => _writer?.LostFrames ?? 0;

        /// <summary>Starts a new session: the range opens its source anew, so that the recording has its first frame.</summary>
        public void StartRecording()
        {
            if (IsRecording)
                return;
            _isWanted = true;
            if (_range != null)
                _range.Restart();
        }

        /// <summary>Completes the session's files; the range goes on.</summary>
        public void StopRecording()
        {
            _isWanted = false;
            if (_range != null)
                _range.DetachFrames();
            End(true);
        }

        /// <summary>Called by the range as it opens. Null: nothing is recorded.</summary>
        internal SessionLogWriter? Begin(FrameSourceAsset asset, IFrameSource screen, IFrameSource? hands, long handClockOffsetUs, RangeCalibration? calibration)
        {
            End(false);
            if (!_isWanted || !isActiveAndEnabled)
                return null;
            try
            {
                _moved = MovedObjects.None;
                SceneModel? scene = Describe();
                var log = new SessionLog
                {
                    Header = new SessionHeader(PackageVersion.Text, new[] { new SessionInput(screen.Info.Name, null) }, calibration == null ? null : SessionLog.CalibrationFileName, "shots", null),
                    Build = SessionLog.ThisBuild,
                    HandClockOffsetUs = handClockOffsetUs,
                    SceneTimeZeroUs = asset.SceneTimeZeroUs,
                };
                SessionFolder = NextFolder();
                _writer = new SessionLogWriter(SessionFolder, log, ScreenSettings(asset, screen, calibration), hands == null || !_recordsHands ? null : HandSettings(asset, hands),
                    calibration == null ? null : RangeCalibrationFile.Format(calibration), scene, true);
                _running.Restart();
                _toldLost = 0;
                _isToldProblem = false;
            }
            catch (Exception problem) when (problem is InputException || problem is IOException || problem is UnauthorizedAccessException || problem is ArgumentException)
            {
                _moved = MovedObjects.None;
                Tell("nothing is recorded: " + problem.Message.Replace('\n', ' '), true);
            }

            return _writer;
        }

        /// <summary>Called by the range for each of its shots, hit or miss.</summary>
        internal void AddScored(in ShotEvent shot) => _writer?.Events?.Score(shot);

        /// <summary>Called by the range when its detector has stopped.</summary>
        internal void End(bool isComplete)
        {
            if (_writer == null)
                return;
            TellTroubles(_writer);
            _writer.Finish(isComplete, 0, _running.Elapsed.TotalSeconds);
            TellTroubles(_writer);
            _writer = null;
        }

        private void OnEnable()
        {
            _range = GetComponent<LaserRange>();
            _isWanted |= _recordsAlways;
            _range.AttachRecorder(this);
        }

        private void OnDisable()
        {
            if (_range != null)
                _range.DetachFrames();
            End(true);
            _isWanted = false;
        }

        // After everything has moved in this frame.
        private void LateUpdate()
        {
            if (_writer == null)
                return;
            if (_writer.Poses != null)
                _moved.Log(_writer.Poses, Time.timeAsDouble, _range!.SceneClockOffsetS);
            TellTroubles(_writer);
            if (_range != null && _range.HasToldAll)
                End(true);
        }

        private FrameRecorderSettings ScreenSettings(FrameSourceAsset asset, IFrameSource source, RangeCalibration? calibration)
        {
            FrameRecorderSettings settings = Settings(asset, source);
            settings.DeviceCalibration = () => asset.DeviceCalibration;
            settings.JpegQuality = _jpegQuality;
            if (!_screenOnly)
                return settings;
            if (calibration != null && ScreenRegion.TryFind(calibration, ScreenRegion.DefaultMarginPx, out PixelRegion region))
                settings.Region = region;
            else
                Tell("the screen's place in the picture is not known, so whole pictures are recorded; calibrate it", false);
            return settings;
        }

        /// <summary>Of camera 1, which may be an asset of its own.</summary>
        private FrameRecorderSettings HandSettings(FrameSourceAsset asset, IFrameSource source)
        {
            FrameSourceAsset? own = _range!.HandSource;
            FrameRecorderSettings settings = Settings(asset, source);
            settings.DeviceCalibration = () => own is null ? asset.HandDeviceCalibration : own.DeviceCalibration;
            return settings;
        }

        /// <summary>A camera does not wait for the disk; what is played can.</summary>
        private static FrameRecorderSettings Settings(FrameSourceAsset asset, IFrameSource source) =>
            new FrameRecorderSettings { FramesPerSecond = source.Info.NominalFramesPerSecond, WaitsWhenFull = !asset.IsLive };

        /// <summary>Without a scene the frames are recorded all the same.</summary>
        private SceneModel? Describe()
        {
            try
            {
                return SceneModelBuilder.Build(_range!, out _moved);
            }
            catch (InputException problem)
            {
                Tell("the scene is not recorded, so a replay finds shots but no hits: " + problem.Message, false);
                return null;
            }
        }

        private string NextFolder()
        {
            string root = UserPath.Under(Application.persistentDataPath, _folder);
            for (int number = 1; number <= MaxSessions; number++)
            {
                string folder = Path.Combine(root, "session-" + number.ToString("0000", CultureInfo.InvariantCulture));
                if (!Directory.Exists(folder) && !File.Exists(folder))
                    return folder;
            }

            throw new InputException(root, "is full of sessions", "move them elsewhere");
        }

        /// <summary>Once for each time that the lost frames double, and once for what ended a recording.</summary>
        private void TellTroubles(SessionLogWriter writer)
        {
            long lost = writer.LostFrames;
            if (lost > 0 && lost >= 2 * _toldLost)
            {
                _toldLost = lost;
                Tell(lost + " frames are not in the recording because the disk does not keep up; record only the screen's part, or on a faster disk", false);
            }

            if (writer.Problem.Length == 0 || _isToldProblem)
                return;
            _isToldProblem = true;
            Tell(writer.Problem, true);
        }

        private void Tell(string text, bool isError)
        {
            text = "RangeRecorder " + name + ": " + text;
            ShotEmitters.Log(this, text, isError);
            if (_range != null)
                _range.AddHealth(new HealthEvent { FrameIndex = -1, Kind = HealthKind.SetUp, Text = text });
        }
    }
}
