using System;
using System.Globalization;

namespace LaserTracking.Capture.Live
{
    /// <summary>
    /// The life of one live camera, step by step and without a thread: look for it, read it, lock its settings, and when it is gone look
    /// again, ever more seldom. Never throws: whatever the vendor's library throws counts as a lost camera. Allocates nothing of its own
    /// while pictures come.
    /// </summary>
    public sealed class LiveCameraLoop
    {
        private readonly ILiveCamera _camera;
        private readonly LiveCameraSettings _settings;
        private readonly Func<long> _nowUs;
        private readonly Action<string> _report;
        private readonly DeviceClock _clock;
        private readonly RetryDelay _retry;
        private readonly SettingsLock _lock;
        private long _retryAtUs = long.MinValue;
        private long _heardUs;
        private long _lostUs;
        private bool _hasPicture;
        private bool _isMissing;
        private string _lastProblem = "";

        /// <param name="camera">Opened, read and closed here only.</param>
        /// <param name="settings">Times.</param>
        /// <param name="nowUs">Host's clock, microseconds, never back.</param>
        /// <param name="report">Takes what the operator should know, one line each; what goes on is said once.</param>
        public LiveCameraLoop(ILiveCamera camera, LiveCameraSettings settings, Func<long> nowUs, Action<string> report)
        {
            _camera = camera;
            _settings = settings.Validated();
            _nowUs = nowUs;
            _report = text => report(camera.Info.Name + ": " + text);
            _clock = new DeviceClock(settings.LatencyMs);
            _retry = new RetryDelay(settings.FirstRetryMs, settings.LongestRetryMs);
            _lock = new SettingsLock(camera, settings, _report);
        }

        public bool IsOpen { get; private set; }

        /// <summary>
        /// One try: to open the camera when it is due, or to read a picture. True when the frame holds one, with its times on the host's
        /// clock.
        /// </summary>
        /// <param name="frame">Filled when true is returned.</param>
        /// <param name="waitMs">How long the caller should wait before the next step; 0: not at all.</param>
        public bool TryStep(Frame frame, out int waitMs)
        {
            waitMs = 0;
            try
            {
                if (IsOpen)
                    return TryRead(frame);
                long waitUs = _retryAtUs - _nowUs();
                if (_retryAtUs != long.MinValue && waitUs > 0)
                    waitMs = (int)Math.Min(waitUs / 1000 + 1, _settings.ReadTimeoutMs);
                else
                    Open();
            }
            catch (Exception problem)
            {
                // A vendor's library may throw anything, and a camera that fails must not take the session with it.
                Lose(VendorLibrary.Describe(problem));
            }

            return false;
        }

        /// <summary>Closes the camera for good.</summary>
        public void Close()
        {
            try
            {
                _camera.Close();
            }
            catch (Exception problem)
            {
                _report("cannot be closed: " + VendorLibrary.Describe(problem));
            }

            IsOpen = false;
        }

        private void Open()
        {
            if (!_camera.TryOpen(out string problem))
            {
                Lose(problem);
                return;
            }

            IsOpen = true;
            _hasPicture = false;
            _heardUs = _nowUs();
            _clock.Restart();
            _lock.Restart();
        }

        private bool TryRead(Frame frame)
        {
            LiveReading reading = _camera.Read(frame, _settings.ReadTimeoutMs, out string problem);
            long now = _nowUs();
            if (reading == LiveReading.Picture)
            {
                Take(frame, now);
                return true;
            }

            long limitMs = _hasPicture ? _settings.SilenceMs : _settings.FirstPictureMs;
            if (reading == LiveReading.Lost)
                Lose(problem);
            else if (now - _heardUs > limitMs * 1000)
                Lose(problem.Length > 0 ? problem : "no picture for " + Seconds(now - _heardUs) + "; check its cable and power, and that no other program uses it");
            return false;
        }

        private void Take(Frame frame, long now)
        {
            _heardUs = now;
            _hasPicture = true;
            _retry.Reset();
            if (_isMissing)
                _report("is back after " + Seconds(now - _lostUs));
            _isMissing = false;
            _lastProblem = "";
            long shiftUs = _clock.Map(frame.TimeUs, now) - frame.TimeUs;
            frame.TimeUs += shiftUs;
            frame.Color.TimeUs += shiftUs;
            frame.Depth.TimeUs += shiftUs;
            frame.Infrared.TimeUs += shiftUs;
            _lock.Update(now);
        }

        private void Lose(string problem)
        {
            Close();
            long now = _nowUs();
            if (!_isMissing)
                _lostUs = now;
            _isMissing = true;
            _retryAtUs = now + _retry.Next();
            if (problem != _lastProblem)
                _report(problem + "; it is looked for until it is there");
            _lastProblem = problem;
        }

        private static string Seconds(long us) => (us * 1e-6).ToString("F1", CultureInfo.InvariantCulture) + " s";
    }
}
