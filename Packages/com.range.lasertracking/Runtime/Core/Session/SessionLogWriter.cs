using System;
using System.IO;
using System.Text;
using LaserTracking.Capture;
using LaserTracking.Capture.Recording;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>
    /// Records a session into a folder of its own: both cameras' frames as the pipeline gets them, calibration, scene with its poses,
    /// settings; and its events, where somebody has them. Frames of one camera from one thread at a time, poses from one thread. What
    /// is written is flushed to the disk every second.
    /// </summary>
    public sealed class SessionLogWriter : IDisposable
    {
        private readonly SessionLog _log;
        private readonly string _folder;
        private FrameRecorder? _screen;
        private FrameRecorder? _hands;
        private WriteBehindStream? _eventFile;
        private WriteBehindStream? _poseFile;
        private DiskFlusher? _flusher;
        private SessionEnd _soFar;
        private bool _isDisposed;

        /// <param name="folder">Made; must not hold a session yet.</param>
        /// <param name="log">What is known of the session; completed and kept by this object.</param>
        /// <param name="screen">How camera 0 is recorded.</param>
        /// <param name="hands">How camera 1 is; null: there is none.</param>
        /// <param name="calibration">Text of the calibration file; null: none.</param>
        /// <param name="scene">What is shot at; null: nothing.</param>
        /// <param name="withEvents">Writes events.jsonl there too: see <see cref="Events"/>.</param>
        /// <exception cref="InputException">The folder holds a session, or cannot be written to.</exception>
        public SessionLogWriter(string folder, SessionLog log, FrameRecorderSettings screen, FrameRecorderSettings? hands, string? calibration, SceneModel? scene, bool withEvents = false)
        {
            if (SessionLog.IsIn(folder))
                throw new InputException(folder, "holds a session already, which is not overwritten", "name another folder");
            _folder = folder;
            _log = log;
            log.HasHandFrames = hands != null;
            log.HasCalibration = calibration != null;
            log.HasScene = scene != null;
            log.IsReduced = screen.Region != null || screen.JpegQuality > 0;
            try
            {
                _screen = new FrameRecorder(Path.Combine(folder, SessionLog.ScreenFramesName), screen);
                _hands = hands == null ? null : new FrameRecorder(Path.Combine(folder, SessionLog.HandFramesName), hands);
                if (calibration != null)
                    File.WriteAllText(Path.Combine(folder, SessionLog.CalibrationFileName), calibration, new UTF8Encoding(false));
                if (scene != null)
                {
                    _poseFile = Create(SessionLog.SceneFileName);
                    Poses = new ScenePoseLog(_poseFile, scene);
                    _poseFile.Drain();
                }

                if (withEvents)
                {
                    _eventFile = Create(SessionLog.EventsFileName);
                    Events = new ScoredLaterSink(new JsonLinesSink(_eventFile), log.Header);
                }

                SessionLogFile.Write(log, folder);
                _flusher = new DiskFlusher(Directory.GetFiles(folder));
            }
            catch (Exception problem)
            {
                CloseAll();
                if (problem is IOException || problem is UnauthorizedAccessException)
                    throw new InputException(folder, "the session cannot be recorded there (" + problem.Message.Replace('\n', ' ').TrimEnd('.') + ")", "name another folder, or make room");
                throw;
            }
        }

        /// <summary>For objects that something else than their own path moves; null without a scene.</summary>
        public ScenePoseLog? Poses { get; private set; }

        /// <summary>
        /// Gets the pipeline's events; whoever scores the shots gives each of them back, hit or miss. Null: nobody asked for them.
        /// </summary>
        public ScoredLaterSink? Events { get; private set; }

        /// <summary>Camera 0's frames written so far.</summary>
        public long RecordedFrames => _screen?.RecordedFrames ?? 0;

        /// <summary>Frames of both cameras that are not in the recordings though they should be.</summary>
        public long LostFrames => Lost(_screen) + Lost(_hands);

        /// <summary>Why a recording ended early, one line; empty: none did.</summary>
        public string Problem => _screen?.Problem is { Length: > 0 } screen ? screen : _hands?.Problem is { Length: > 0 } hands ? hands
            : _poseFile?.Problem is { Length: > 0 } poses ? poses : _eventFile?.Problem ?? "";

        /// <summary>For the tap of camera 0's source.</summary>
        public void AddScreenFrame(Frame frame)
        {
            _screen?.Add(frame);
            _soFar.StartTimeUs ??= frame.TimeUs;
            _soFar.Frames++;
            _soFar.Dropped += frame.Color.IsPresent ? 0 : 1;
            _soFar.SecondsMedia = (frame.TimeUs - _soFar.StartTimeUs.Value) * 1e-6;
        }

        /// <summary>For the tap of camera 1's source: its times as the camera tells them.</summary>
        public void AddHandFrame(Frame frame) => _hands?.Add(frame);

        /// <summary>Completes recordings and log. The disk may be full by now: <see cref="Problem"/> says so.</summary>
        /// <param name="isComplete">The session went on to its end: a replay gives its bytes.</param>
        /// <param name="inputProblems">What the sources reported damaged, which the recordings cannot show again.</param>
        /// <param name="secondsWall">What the session took by the host's clock, for the last line of its events where the pipeline goes on.</param>
        public void Finish(bool isComplete, int inputProblems, double secondsWall = 0)
        {
            if (_isDisposed)
                return;
            FinishEvents(secondsWall);
            CloseAll();
            _log.Frames = (_screen?.RecordedFrames ?? 0) + (_hands?.RecordedFrames ?? 0);
            _log.Lost = LostFrames;
            _log.InputProblems = inputProblems;
            _log.HasHandFrames &= _hands?.RecordedFrames > 0;
            _log.IsComplete = isComplete && Problem.Length == 0;
            try
            {
                SessionLogFile.Write(_log, _folder);
            }
            catch (Exception problem) when (problem is IOException || problem is UnauthorizedAccessException)
            {
                // The one from the beginning is still there and says that the session is not complete.
            }
        }

        public void Dispose() => Finish(false, 0);

        private static long Lost(FrameRecorder? recorder) => recorder == null ? 0 : recorder.DroppedFrames + recorder.LeftOutPictures;

        private WriteBehindStream Create(string name)
        {
            string path = Path.Combine(_folder, name);
            return new WriteBehindStream(new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.ReadWrite), path);
        }

        private void FinishEvents(double secondsWall)
        {
            if (Events == null)
                return;
            _soFar.SecondsWall = secondsWall;
            SessionEnd end = Events.PipelineEnd ?? _soFar;
            Events.Finish(end);
            _log.SecondsWall = end.SecondsWall;
        }

        private void CloseAll()
        {
            _isDisposed = true;
            _flusher?.Dispose();
            _screen?.Dispose();
            _hands?.Dispose();
            Poses?.Dispose();
            _poseFile?.Dispose();
            _eventFile?.Dispose();
        }
    }
}
