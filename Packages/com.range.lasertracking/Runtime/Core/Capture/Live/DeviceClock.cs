using System;

namespace LaserTracking.Capture.Live
{
    /// <summary>
    /// Brings a device's times on the host's clock, which all live cameras share: intervals stay the device's, jitter of the arrival does
    /// not show, a device that was unplugged and counts from zero again goes on where it was. The quickest arrivals tell the offset;
    /// it follows them so slowly that no interval is bent by more than 0.02 % (1 % in the first seconds). Times strictly rise.
    /// </summary>
    public sealed class DeviceClock
    {
        private const double SteadySlew = 200e-6;
        private const double StartSlew = 0.01;
        private const long StartUs = 5_000_000;
        private const long WindowUs = 2_000_000;

        /// <summary>A device's clock that jumps by more than this against the host's was set anew.</summary>
        private const long JumpUs = 1_000_000;

        private readonly long _latencyUs;
        private bool _isSet;
        private bool _wasClosed;
        private double _offsetUs;
        private double _targetUs;
        private long _startedUs;
        private long _windowBeganUs;
        private long _windowLeastUs;
        private long _lastDeviceUs;
        private long _lastArrivalUs;
        private long _lastUs = long.MinValue;

        /// <param name="latencyMs">From the light to the arrival of its picture, milliseconds, about.</param>
        public DeviceClock(double latencyMs)
        {
            _latencyUs = (long)Math.Round(latencyMs * 1000);
        }

        /// <summary>The device was closed: its clock may begin anew.</summary>
        public void Restart() => _wasClosed = true;

        /// <summary>Time of a picture on the host's clock, microseconds.</summary>
        /// <param name="deviceUs">Its time on the device's clock.</param>
        /// <param name="arrivalUs">When it arrived, on the host's clock.</param>
        public long Map(long deviceUs, long arrivalUs)
        {
            long offset = arrivalUs - deviceUs - _latencyUs;
            bool hasJumped = _isSet && Math.Abs(deviceUs - _lastDeviceUs - (arrivalUs - _lastArrivalUs)) > JumpUs;
            if (!_isSet || hasJumped || (_wasClosed && Math.Abs(offset - _offsetUs) > JumpUs / 10))
                Begin(offset, arrivalUs);
            else
                Follow(offset, arrivalUs, deviceUs - _lastDeviceUs);
            _wasClosed = false;
            _lastDeviceUs = deviceUs;
            _lastArrivalUs = arrivalUs;
            _lastUs = Math.Max(_lastUs == long.MinValue ? long.MinValue : _lastUs + 1, deviceUs + (long)Math.Round(_offsetUs));
            return _lastUs;
        }

        private void Begin(long offset, long arrivalUs)
        {
            _isSet = true;
            _offsetUs = _targetUs = offset;
            _startedUs = _windowBeganUs = arrivalUs;
            _windowLeastUs = offset;
        }

        /// <summary>
        /// The least offset of a window is the quickest arrival's. A quicker one is proof at once; that all have become slower is
        /// proven by a whole window.
        /// </summary>
        private void Follow(long offset, long arrivalUs, long intervalUs)
        {
            _windowLeastUs = Math.Min(_windowLeastUs, offset);
            double most = Math.Max(0, intervalUs) * (arrivalUs - _startedUs < StartUs ? StartSlew : SteadySlew);
            if (_windowLeastUs < _targetUs)
                _targetUs = _windowLeastUs;
            if (arrivalUs - _windowBeganUs >= WindowUs)
            {
                _targetUs = _windowLeastUs;
                _windowBeganUs = arrivalUs;
                _windowLeastUs = offset;
            }

            _offsetUs += Math.Max(-most, Math.Min(most, _targetUs - _offsetUs));
        }
    }
}
