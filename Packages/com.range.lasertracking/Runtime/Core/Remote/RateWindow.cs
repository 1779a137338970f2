using System;

namespace LaserTracking.Remote
{
    /// <summary>At most so many in any second: remembers when the last ones were. One thread.</summary>
    internal sealed class RateWindow
    {
        private const long WindowUs = 1_000_000;

        private readonly long[] _timesUs;
        private int _oldest;

        public RateWindow(int perSecond)
        {
            _timesUs = new long[perSecond];
            Clear();
        }

        public void Clear() => Array.Fill(_timesUs, long.MinValue);

        /// <summary>True when one more is allowed now. A clock that was set back counts as a new second.</summary>
        public bool IsOpen(long nowUs) => _timesUs[_oldest] == long.MinValue || nowUs - _timesUs[_oldest] >= WindowUs || nowUs < _timesUs[_oldest];

        public bool TryTake(long nowUs)
        {
            if (!IsOpen(nowUs))
                return false;
            _timesUs[_oldest] = nowUs;
            _oldest = (_oldest + 1) % _timesUs.Length;
            return true;
        }
    }
}
