using System;

namespace LaserTracking.Capture.Live
{
    /// <summary>
    /// Locks a camera's settings once its pictures come, reads them back, and says when the camera has something else: then, by what it
    /// tells when asked, or by what its pictures were taken with. Goes on checking, and sets again what was lost.
    /// </summary>
    public sealed class SettingsLock
    {
        private const int Attempts = 3;
        private const long AttemptUs = 1_000_000;

        /// <summary>Pictures in a row taken with another value that prove that a setting does not hold: some are on their way when it is set.</summary>
        private const int WrongPictures = 10;

        private readonly ILiveCamera _camera;
        private readonly long _settleUs;
        private readonly long _checkUs;
        private readonly Action<string> _report;
        private readonly int[] _wrong;
        private readonly bool[] _isReported;
        private long _dueUs;
        private int _failures;
        private bool _hasBegun;
        private bool _isLocked;

        /// <param name="camera">Whose settings they are.</param>
        /// <param name="settings">Times.</param>
        /// <param name="report">Takes what the operator should know, one line.</param>
        public SettingsLock(ILiveCamera camera, LiveCameraSettings settings, Action<string> report)
        {
            _camera = camera;
            _settleUs = settings.SettleMs * 1000L;
            _checkUs = settings.CheckMs * 1000L;
            _report = report;
            _wrong = new int[camera.Settings.Count];
            _isReported = new bool[camera.Settings.Count];
        }

        /// <summary>The camera was closed: nothing is locked any more.</summary>
        public void Restart()
        {
            _hasBegun = _isLocked = false;
            _failures = 0;
            Array.Clear(_wrong, 0, _wrong.Length);
        }

        /// <summary>After every picture.</summary>
        /// <param name="nowUs">Host's clock, microseconds.</param>
        public void Update(long nowUs)
        {
            if (!_hasBegun)
            {
                _hasBegun = true;
                _dueUs = nowUs + _settleUs;
            }

            if (_isLocked)
                CountWrongPictures();
            if (nowUs < _dueUs)
                return;
            bool wasLocked = _isLocked, isMet = true;
            for (int i = 0; i < _wrong.Length; i++)
            {
                double? value = null;
                if (wasLocked && IsMet(i, out value))
                {
                    Say(i, true, value);
                    continue;
                }

                isMet = false;
                if (_failures >= Attempts)
                    Say(i, false, value);
                _camera.TrySet(_camera.Settings[i]);
                _wrong[i] = 0;
            }

            _isLocked = true;
            _failures = isMet ? 0 : _failures + 1;
            _dueUs = nowUs + (isMet || _failures > Attempts ? _checkUs : AttemptUs);
        }

        private void CountWrongPictures()
        {
            for (int i = 0; i < _wrong.Length; i++)
            {
                CameraSetting setting = _camera.Settings[i];
                bool isWrong = _camera.TryGetUsed(setting, out double used) && !setting.IsMetBy(used);
                _wrong[i] = isWrong ? Math.Min(WrongPictures, _wrong[i] + 1) : 0;
            }
        }

        /// <summary>What pictures say goes before what the camera says when asked; asking costs a transfer on its bus.</summary>
        private bool IsMet(int index, out double? value)
        {
            CameraSetting setting = _camera.Settings[index];
            bool hasUsed = _camera.TryGetUsed(setting, out double used);
            if (hasUsed && _wrong[index] == WrongPictures)
                value = used;
            else
                value = _camera.TryGet(setting, out double told) ? told : hasUsed ? used : (double?)null;
            return value.HasValue && setting.IsMetBy(value.Value);
        }

        /// <summary>Each setting once when it is refused and once when it holds after all.</summary>
        private void Say(int index, bool isMet, double? value)
        {
            if (isMet == !_isReported[index])
                return;
            _isReported[index] = !isMet;
            CameraSetting setting = _camera.Settings[index];
            if (isMet)
                _report(setting.Name + " is now " + setting.Text(value!.Value) + ", as asked");
            else
                _report(setting.Name + ": asked for " + setting.Text(setting.Asked) + ", the camera " + (value.HasValue ? "has " + setting.Text(value.Value) : "does not tell what it has") + "; " + setting.Remedy);
        }
    }
}
